3.1
unknown command comes first
GOTOO L1:
IFF 1 == 1 THEN
FOO 5 -
END
