# SPDX-License-Identifier: Apache-2.0
"""SIM-2: faults that add characters, come by chance, or stop a telemetry
board."""

import pytest
from conftest import (
    CHARACTER_US,
    COMMANDS,
    DOWNLINK_CHARACTERS,
    NUMBERS,
    SENSORS,
    UPLINK_CHARACTERS,
)

# The first exchange after this time: 30 characters of data and a command to
# downlink up; a status, 58 characters of data down; a status up.
TIME_MS = 200
LINK = ("uplink_sent", "uplink_received", "uplink_bad", "downlink_sent",
        "downlink_received", "downlink_bad", "gsc_resets", "mcs_resets")
CLEAN = (49, 49, 0, 48, 48, 0, 0, 0)

# Its command: the uplink begins 4 ms after the frame and has 30 characters,
# the aircraft waits for 1.5 (between 1 and 2), its status is one.
COMMAND_US = 204_000 + 96 * 30 + 144 + 96


def link_counts(fly, write, faults, *options):
    write("faults.txt", faults)
    flight = fly("--faults", "faults.txt", "--seconds", "1", *options)
    return tuple(flight.summary["link"][name] for name in LINK)


def test_counts_without_a_fault(fly, write):
    assert link_counts(fly, write, "# none\n") == CLEAN


@pytest.mark.parametrize("fault, meant", [
    # A data message that is a character too long is bad, and sent again; the
    # downlink comes so late that it is a newer one.
    ("up dup 2", (50, 49, 1, 47, 47, 0, 0, 0)),
    ("up insert 2 00", (50, 49, 1, 47, 47, 0, 0, 0)),
    # Sent again, a downlink meets the next one.
    ("down dup 3", (49, 49, 0, 48, 47, 1, 0, 0)),
    # The last character of a message doubled: the receiver waits, and hears.
    ("up dup 30", (50, 49, 1, 47, 47, 0, 0, 0)),
    ("down dup 59", (49, 49, 0, 48, 47, 1, 0, 0)),
    # A status, a command doubled.
    ("down dup 1", CLEAN),
    ("up dup 31", CLEAN),
    ("up dup 32", CLEAN),
    # A first byte that is no header: the aircraft waits for silence, the
    # ground sends again, so late that the downlink is a newer one.
    ("up insert 1 00", (50, 49, 0, 47, 47, 0, 1, 1)),
    # A status where data should begin is disregarded.
    ("down insert 2 2d", CLEAN),
])
def test_an_added_character(fly, write, fault, meant):
    assert link_counts(fly, write, f"{TIME_MS} {fault}\n") == meant


def crc8(message):
    """CRC-8/DARC: x^8 + x^5 + x^4 + x^3 + 1, low bit first."""
    total = 0
    for byte in message:
        total ^= byte
        for _ in range(8):
            total = total >> 1 ^ (0x9C if total & 1 else 0)
    return total


def test_checksum_is_that_of_the_protocol():
    assert crc8(b"123456789") == 0x15


@pytest.mark.parametrize("sealed", [False, True])
@pytest.mark.parametrize("way, header, length", [
    ("up", 0x1E, UPLINK_CHARACTERS), ("down", 0x87, DOWNLINK_CHARACTERS)])
def test_d27_a_character_doubled_where_the_checksum_cannot_tell(
        fly, write, tmp_path, way, header, length, sealed):
    """A message that is a character longer, and whose last byte of data is
    the checksum of all that came before it, as in one case of 256: it looks
    well a character early. Such a message turned on a switch that nobody had
    asked for. It is bad, and the block comes by its second transmission."""
    options = []
    if sealed:
        key = tmp_path / "keys"
        key.write_text("key 1 000102030405060708090a0b0c0d0e0f\n")
        key.chmod(0o600)
        options = ["--format", "2", "--key", str(key)]
    for name, words in (("sticks", COMMANDS), ("sensors", SENSORS)):
        write(f"{name}.csv", f"time_ms,{words[0]},{words[1]}\n" + "".join(
            f"{time_ms},{time_ms * 7 % 4096},{time_ms * 31 % 4096}\n"
            for time_ms in range(0, 4000, 20)))
        options += [f"--{name}", f"{name}.csv"]
    clean = fly("--seconds", "4", *options, name="clean")
    sent = [row for row in clean.wire if row.direction == way]
    unseen = []
    place = 0
    while place < len(sent):
        message = bytes(row.byte for row in sent[place:place + length])
        if message[0] != header:
            place += 1
            continue
        unseen += [(sent[place].time_us, doubled + 1)
                   for doubled in range(length - 1)
                   if crc8(message[:doubled + 1] + message[doubled:-2])
                   == message[-2]]
        place += length
    assert len(unseen) > 10
    for time_us, doubled in unseen[3:9]:
        write("faults.txt", f"{ms(time_us)} {way} dup {doubled}\n")
        until = time_us // 20_000 * 20 + 100
        flight = fly("--seconds", f"{until / 1000}", "--faults", "faults.txt",
                     *options, name=f"{time_us}")
        counts = flight.summary["link"]
        assert counts[f"{way}link_bad"] == 1
        assert counts[f"{way}link_sent"] - counts[
            f"{way}link_received"] == 1


def test_wire_shows_what_is_sent_not_what_is_added(fly, write):
    write("faults.txt", f"{TIME_MS} up dup 31\n{TIME_MS} down dup 1\n")
    faulty = fly("--faults", "faults.txt", "--seconds=0.22", name="faulty")
    clean = fly("--seconds=0.22", name="clean")
    assert faulty.path("wire.csv").read_bytes() == clean.path(
        "wire.csv").read_bytes()


def test_more_than_the_line_has_room_for_is_not_heard(fly, write):
    faults = f"{TIME_MS} up insert 1 00\n" * 100 + f"{TIME_MS} up dup 5\n" * 99
    assert link_counts(fly, write, faults)[1] == 49


# --- stalls ---------------------------------------------------------------

def bytes_between(flight, way, first_ms, stop_ms):
    return [row for row in flight.wire if row.direction == way
            and first_ms * 1000 <= row.time_us < stop_ms * 1000]


@pytest.mark.parametrize("node, way", [("gsc", "up"), ("mcs", "down")])
def test_a_stalled_board_is_silent_then_goes_on(fly, write, node, way):
    write("faults.txt", f"206.5 {node} stall telemetry 100\n")
    flight = fly("--faults", "faults.txt", "--seconds=1")
    assert bytes_between(flight, way, 206.5, 306.5) == []
    # In a major frame that begins a frame after the end all is well.
    record = flight.record
    for frame in range(18, 50):
        for count in ("link.uplink_received", "link.downlink_received"):
            assert record[count][frame] == record[count][frame - 1] + 1


def test_a_stall_within_a_message_leaves_a_gap(fly, write):
    # Nine characters of ten; the last begins before the stall and leaves.
    write("faults.txt", "204.9 gsc stall telemetry 0.5\n")
    flight = fly("--faults", "faults.txt", "--seconds=0.4")
    times = [row.time_us for row in bytes_between(flight, "up", 204, 208)]
    gaps = [b - a for a, b in zip(times, times[1:], strict=False)]
    assert [gap for gap in gaps[:29] if gap != 96] == [205400 - times[9]]
    assert times[9] < 204900 < times[9] + 96
    assert flight.summary["link"]["uplink_bad"] == 0


def test_timers_of_a_stalled_board_stand_still(fly, write):
    # The uplink is lost. Without a stall the ground gives up 20 characters
    # after its last one, stays idle for 24, and sends again.
    cut = "203 cut 5\n"
    write("plain.txt", cut)
    write("stalled.txt", cut + "207.5 gsc stall telemetry 1.1\n")

    def second_time(name):
        flight = fly("--faults", name, "--seconds=0.4", name=name[:3])
        return [row for row in flight.wire if row.direction == "up"
                and row.time_us >= 204000][UPLINK_CHARACTERS].time_us

    again = 204000 + CHARACTER_US * (
        UPLINK_CHARACTERS + NUMBERS.dead_space_characters
        + NUMBERS.idle_characters)
    assert second_time("plain.txt") == again
    assert second_time("stalled.txt") == again + 1100


def test_stalls_that_overlap_are_one(fly, write):
    one = link_counts(fly, write, "200 mcs stall telemetry 50\n")
    many = link_counts(fly, write, "220 mcs stall telemetry 30\n"
                       "200 mcs stall telemetry 25\n"
                       "210 mcs stall telemetry 1\n"
                       "230 mcs stall telemetry 0\n")
    assert one == many


def test_a_board_that_is_stalled_from_the_start(fly, write):
    counts = link_counts(fly, write, "0 mcs stall telemetry 500\n")
    assert counts[1] == 25


def test_an_inserted_command_is_obeyed_at_once(fly, write):
    # The aircraft begins as the ground's own command does.
    write("faults.txt", f"{TIME_MS} up insert 31 4b\n")
    flight = fly("--faults", "faults.txt", "--seconds=1")
    both = [row for row in flight.wire if row.time_us == COMMAND_US]
    assert [(row.direction, row.byte) for row in both] == [
        ("up", 0x4B), ("down", 0x87)]
    assert flight.summary["link"]["downlink_received"] == CLEAN[4]


# --- bit errors by chance -------------------------------------------------

NOISE = "0 up ber 1e-4 1000\n0 down ber 1e-4 1000\n"


def test_bit_errors_come_from_the_seed_alone(fly, write):
    def outputs(seed, name):
        write("faults.txt", NOISE)
        flight = fly("--faults", "faults.txt", "--seconds=2",
                     f"--seed={seed}", name=name)
        return [flight.path(file).read_bytes()
                for file in ("record.csv", "wire.csv")]

    assert outputs(7, "a") == outputs(7, "b")
    assert outputs(7, "a") != outputs(8, "c")


@pytest.mark.parametrize("rate", [1e-4, 1e-2, 0.5])
def test_noise_is_splitmix64(fly, write, rate):
    """The same flight with each flip written out, from another program."""
    write("noise.txt", f"0 up ber {rate} 1000\n0 down ber {rate} 1000\n")
    noisy = fly("--faults=noise.txt", "--seconds=1", "--seed=5", name="noisy")
    write("flips.txt", "".join(
        f"0 {way} flip {number} {mask:x}\n" for way in ("up", "down")
        for number, mask in known_hits(
            5, way, rate,
            sum(row.direction == way for row in noisy.wire)).items()))
    flipped = fly("--faults=flips.txt", "--seconds=1", name="flipped")
    for file in ("record.csv", "wire.csv"):
        assert noisy.path(file).read_bytes() == flipped.path(file).read_bytes()


MASK_64 = 2**64 - 1


def splitmix64(state):
    while True:
        state = (state + 0x9E3779B97F4A7C15) & MASK_64
        z = state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK_64
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK_64
        yield z ^ (z >> 31)


def known_hits(seed, way, rate, characters):
    """The mask of each of the first characters that is hit, by number."""
    split = splitmix64(seed)
    up, down = next(split), next(split)
    numbers = splitmix64(up if way == "up" else down)
    unit = int(rate * 2**64)
    first = [unit]
    for _ in range(8):
        first.append(first[-1] + ((2**64 - first[-1]) * unit >> 64))
    hits = {}
    for number in range(1, characters + 1):
        value = next(numbers)
        if value < first[8]:
            bit = next(n for n in range(9) if value < first[n])
            mask = 1 << bit
            for further in range(bit + 1, 9):
                mask |= (next(numbers) < unit) << further
            hits[number] = mask
    return hits


def test_certain_errors_flip_every_bit(fly, write):
    # All nine bits: the byte is inverted and its parity is wrong.
    counts = link_counts(fly, write, "0 up ber 1 1000\n")
    assert counts[:3] == (98, 0, 0)
    assert link_counts(fly, write, "0 up ber 0 1000\n") == CLEAN


def test_noise_of_several_lines_adds_up(fly, write):
    # Flipped twice is not flipped.
    assert link_counts(fly, write, "0 up ber 1 1000\n" * 2) == CLEAN


# --- a telemetry board starts again ------------------------------------------


# When, who, and what is counted in the flight; the frames in which less than a
# block each way comes.
ANEW = [
    # Before the exchange and after it nothing is lost.
    (201.5, "gsc", CLEAN, []), (201.5, "mcs", CLEAN, []),
    (213.0, "gsc", CLEAN, []), (213.0, "mcs", CLEAN, []),
    # Within the uplink: it is broken off, or heard by a board that knows
    # nothing of it. It comes again, and the downlink so late that it is a
    # newer one.
    (204.9, "gsc", (50, 49, 1, 47, 47, 0, 0, 1), [11]),
    (204.9, "mcs", (50, 49, 0, 47, 47, 0, 1, 1), [10]),
    # While the downlink comes: the ground hears none of it, and has nothing
    # to send before its next frame.
    (207.19, "gsc", (49, 49, 0, 48, 47, 0, 0, 1), [10]),
    (209.9, "gsc", (49, 49, 0, 48, 47, 0, 0, 1), [10]),
    # The aircraft breaks it off, and is asked once more.
    (207.19, "mcs", CLEAN, []),
    (209.9, "mcs", (49, 49, 0, 48, 47, 1, 1, 0), [11]),
]


@pytest.mark.parametrize("time, node, counts, missing", ANEW)
def test_lnk9_a_restarted_board_flies_on(
        fly, write, time, node, counts, missing):
    write("faults.txt", f"{time} {node} reset telemetry\n")
    flight = fly("--seconds", "1", "--faults", "faults.txt")
    assert tuple(flight.summary["link"][name] for name in LINK) == counts
    received = [flight.record[f"link.{way}_received"]
                for way in ("uplink", "downlink")]
    assert [frame for frame in range(9, 50) if any(
        count[frame] != count[frame - 1] + 1 for count in received)
            ] == missing


# --- which character it is, to the microsecond ---------------------------------

# The uplink of the frame that begins at 200 ms: when each character is sent.
FIRST_US = 204_000


def sent_at(place):
    return FIRST_US + CHARACTER_US * (place - 1)


def ms(time_us):
    return f"{time_us / 1000:.3f}"


@pytest.fixture
def outputs(fly, write):
    """The files of a flight with these faults, to the byte."""

    def of(*faults):
        write("faults.txt", "\n".join(faults) + "\n")
        flight = fly("--faults", "faults.txt", "--seconds=0.4", "--seed=5",
                     name=str(abs(hash(faults))))
        return [flight.path(file).read_bytes()
                for file in ("record.csv", "wire.csv", "events.jsonl")]

    return of


@pytest.mark.parametrize("begin, length, lost", [
    (0, 1, [9]), (95, 1, [9]), (96, 1, [10]), (-1, 1, [8]),
    (95, 2, [9, 10]), (0, 96, [9]), (0, 97, [9, 10]), (1, 96, [9, 10]),
    (-1, 97, [8, 9])])
def test_a_cut_loses_each_character_of_which_a_part_is_in_it(
        outputs, begin, length, lost):
    # One character more makes up for a lost one, unless it is that one: the
    # block comes bad, and not short. It shows the lost ones.
    added = [[f"200 up dup {place}" for place in places]
             for places in ((8,), (9,), (10,), (6, 7))]
    cut = [f"{ms(sent_at(9) + begin)} cut {ms(length)}"]

    def after(places):
        return [outputs(*more, *(f"200 up drop {place}" for place in places))
                for more in added]

    assert [outputs(*more, *cut) for more in added] == after(lost)
    for other in (lost[1:], [lost[0] - 1, *lost], [*lost, lost[-1] + 1]):
        assert after(other) != after(lost)


@pytest.mark.parametrize("begin, length, hit", [
    (0, 1, [9]), (-1, 1, []), (1, 95, []), (1, 96, [10]), (-95, 96, [9]),
    (0, 96, [9]), (0, 97, [9, 10])])
def test_bit_errors_hit_each_character_that_begins_among_them(
        outputs, begin, length, hit):
    # Flipped twice is not flipped, so it shows which ones are hit.
    noise = f"{ms(sent_at(9) + begin)} up ber 1 {ms(length)}"
    clean = outputs("# none")
    for places in ([], [8], [9], [10], [8, 9], [9, 10]):
        flips = [f"200 up flip {place} 1ff" for place in places]
        assert (outputs(noise, *flips) == clean) == (places == hit)


def test_faults_of_a_character_come_in_the_order_of_their_lines(outputs):
    # The command first, and it is obeyed; a byte that is none, and it waits.
    command, other = "200 up insert 31 4b", "200 up insert 31 00"
    assert outputs(command, other) != outputs(other, command)
    # But by their times first: both are of the same character.
    sooner = "199 up insert 31 00"
    assert outputs(command, sooner) == outputs(other, command)


def test_a_character_doubled_twice_comes_three_times(outputs):
    # If it replaces two lost ones, the message has its length.
    once, twice, short = (
        outputs("200 up drop 8", "200 up drop 9", *["200 up dup 5"] * count)
        for count in (1, 2, 0))
    assert once == short != twice
    # A message that is too long is bad, however long.
    one, more = (outputs(*["200 up dup 5"] * count) for count in (1, 2))
    assert one == more


@pytest.mark.parametrize("mask, is_told", [(3, False), (1, True), (100, True),
                                           (101, False), ("1f", True)])
def test_an_odd_number_of_flips_is_a_parity_error_and_an_even_one_is_none(
        fly, write, mask, is_told):
    """Masks of a command in which only the parity shows a changed character:
    4Bh is one away from being none."""
    write("faults.txt", f"200 up flip 31 {mask}\n")
    flight = fly("--faults", "faults.txt", "--seconds=0.4")
    heard = 0x4B ^ (int(str(mask), 16) & 0xFF)
    down = [row for row in flight.wire if row.direction == "down"
            and COMMAND_US < row.time_us < COMMAND_US + 1_000]
    assert bool(down) == (heard == 0x4B and not is_told)


def test_a_character_that_nobody_read_spoils_the_next(outputs):
    """The aircraft's board stalls as the command ends, and the DUART reports
    that with the next character: the second command, which is not heard."""
    stall = f"{ms(COMMAND_US + CHARACTER_US - 2)} mcs stall telemetry 0.010"
    lost = "200 up drop 31"
    spoilt = "200 up flip 32 100"
    stalled, both, one = (outputs(*faults) for faults in (
        [stall], [lost, spoilt], [lost]))
    counts = [
        [count for name, count in zip(
            lines[0].split(b","), lines[-1].split(b","), strict=True)
         if name.startswith(b"link.")]
        for lines in (output[0].splitlines()
                      for output in (stalled, both, one))]
    assert counts[0] == counts[1] != counts[2]
