--  SPDX-License-Identifier: Apache-2.0

with Bare_MCS;

procedure MCS_Image is
begin
   Bare_MCS.Start;
end MCS_Image;
