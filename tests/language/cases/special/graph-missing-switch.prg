3.1
Graph missing switch
SPECIAL 20 0
END
