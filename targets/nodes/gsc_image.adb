--  SPDX-License-Identifier: Apache-2.0

with Bare_GSC;

procedure GSC_Image is
begin
   Bare_GSC.Start;
end GSC_Image;
