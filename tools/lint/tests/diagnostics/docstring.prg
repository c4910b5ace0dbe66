3.1
A title
"""
Walk to the wall, and
ask for a key
"""
SLEEP 100
END
