--  SPDX-License-Identifier: Apache-2.0

with Bench_Boxes;

package Bench_Boxes_66 is new Bench_Boxes (66);
