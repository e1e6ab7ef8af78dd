--  What holds of several packages together, each a procedure without effect
--  whose postcondition is the theorem. GNATprove proves them; nothing runs.

package Theorems with Pure, SPARK_Mode is
end Theorems;
