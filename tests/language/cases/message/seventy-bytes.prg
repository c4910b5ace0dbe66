3.1
Seventy bytes
MESSAGE あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめab
END
