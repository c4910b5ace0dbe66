3.1
message of 71 bytes
MESSAGE aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa
MESSAGE あああああああああああああああああああああああああああああああああああa
MESSAGE ¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥
MESSAGE 😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀abc
END
