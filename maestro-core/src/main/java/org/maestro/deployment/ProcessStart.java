package org.maestro.deployment;

import java.lang.management.ManagementFactory;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The start of a process, as it tells of itself when it joins (ADE, 3.2; A35). Only told to people:
 * nobody starts what a stranger says of himself.
 *
 * @param machine the name of its machine, as the process knows it
 * @param pid its id there
 * @param directory in which it was started
 * @param command its command line
 */
public record ProcessStart(String machine, long pid, String directory, String command) {

  /** Of this process. */
  public static ProcessStart own() {
    ProcessHandle process = ProcessHandle.current();
    return new ProcessStart(
        machineName(),
        process.pid(),
        Path.of("").toAbsolutePath().toString(),
        commandLine(process));
  }

  /** Put together again, as the system tells the beginning of long ones only. */
  private static String commandLine(ProcessHandle process) {
    List<String> words = new ArrayList<>();
    words.add(process.info().command().orElse("java"));
    words.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
    words.add("-cp");
    words.add(System.getProperty("java.class.path"));
    words.add(System.getProperty("sun.java.command", ""));
    return String.join(" ", words);
  }

  /** What this machine calls itself. */
  public static String machineName() {
    try {
      return InetAddress.getLocalHost().getHostName();
    } catch (UnknownHostException e) {
      // A machine without a name still has its loopback address.
      return InetAddress.getLoopbackAddress().getHostAddress();
    }
  }
}
