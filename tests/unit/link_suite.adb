--  SPDX-License-Identifier: Apache-2.0

package body Link_Suite is

   package body Checksum_Tests is separate;

   package body Headers_Tests is separate;

   package body Board_Memory_Tests is separate;

   package body Receivers_Tests is separate;

   package body Senders_Tests is separate;

   package body Codecs_Tests is separate;

   package body Seal_Tests is separate;

   package body Link_Tests is separate;

   package body Slow_Line_Tests is separate;

end Link_Suite;
