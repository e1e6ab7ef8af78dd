--  SPDX-License-Identifier: Apache-2.0

--  The running test card, as a downlink carries it (FTI-12):
--  URV.Card_Status.Card_Word.

pragma SPARK_Mode;

with URVOS; use URVOS;
with URVOS.Shared_Data;

package URV.Shared_Cards is

   package Words is new URVOS.Shared_Data (Word, Initial => 0);

   subtype Store is Words.Store;

end URV.Shared_Cards;
