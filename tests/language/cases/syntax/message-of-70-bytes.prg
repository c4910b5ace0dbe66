3.1
message of 70 bytes
MESSAGE aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa
MESSAGE あああああああああああああああああああああああああああああああああああ
MESSAGE   ¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t¥t   
MESSAGE 😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀😀ab
END
