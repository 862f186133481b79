@echo off
rem Runs MAESTRO on Windows.
setlocal
set "here=%~dp0"
set "java=java"
if defined JAVA_HOME set "java=%JAVA_HOME%\bin\java"
if exist "%here%java\bin\java.exe" set "java=%here%java\bin\java"
"%java%" -XX:+UseSerialGC -Xms128m -Djade.enable.multiple.platforms=false -cp "%here%*;%here%lib\*" org.maestro.launch.Maestro %*
exit /b %errorlevel%
