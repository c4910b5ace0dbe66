3.1
Shift jis second bytes
MESSAGE ƒ\a•\t”\n\ab
END
