3.1
A title
ＰＴＰ　Ｆ１　３９１　２０１　－１５０
END
