/* SPDX-License-Identifier: Apache-2.0 */

/* The fixed workload that the simulation's speed is compared with: the bare
   data path in C. For each major frame, 14 words go up and 28 come down as
   bytes with a checksum, and are checked and unpacked on the other side. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { LONGEST = 28 };

static uint8_t checksum(const uint8_t *data, int length)
{
   uint8_t sum = 0;

   for (int i = 0; i < length; i++) {
      sum ^= data[i];
      for (int bit = 0; bit < 8; bit++)
         sum = (uint8_t)(sum & 1 ? sum >> 1 ^ 0x9C : sum >> 1);
   }
   return sum;
}

/* Sends words as bytes and takes them in again; returns false if the
   checksum does not match. */
static int transfer(const uint16_t *from, uint16_t *to, int words)
{
   uint8_t line[2 * LONGEST + 1];

   for (int i = 0; i < words; i++) {
      line[2 * i] = (uint8_t)(from[i] >> 8);
      line[2 * i + 1] = (uint8_t)from[i];
   }
   line[2 * words] = checksum(line, 2 * words);
   if (checksum(line, 2 * words) != line[2 * words])
      return 0;
   for (int i = 0; i < words; i++)
      to[i] = (uint16_t)(line[2 * i] << 8 | line[2 * i + 1]);
   return 1;
}

int main(int count, char **arguments)
{
   long frames = count > 1 ? atol(arguments[1]) : 1;
   uint16_t sticks[14] = {0}, servos[14], sensors[28] = {0}, shown[28];
   unsigned total = 0;

   for (long frame = 0; frame < frames; frame++) {
      sticks[frame % 14] = (uint16_t)(frame & 0xfff);
      sensors[frame % 28] = (uint16_t)(~frame & 0xfff);
      if (!transfer(sticks, servos, 14) || !transfer(sensors, shown, 28))
         return 1;
      total += servos[frame % 14] + shown[frame % 28];
   }

   /* Printed, so that the compiler can not leave the work out. */
   printf("%u\n", total);
   return 0;
}
