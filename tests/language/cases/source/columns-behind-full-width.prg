3.1
columns behind full width
　あ　= 1
MESSAGE あいう // え
END
