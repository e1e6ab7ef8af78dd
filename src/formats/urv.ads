--  SPDX-License-Identifier: Apache-2.0

--  The application of the unmanned research vehicle: buffers, tasks and the
--  two nodes (report, sections 2, 4 and 5).

package URV with Pure, SPARK_Mode is
end URV;
