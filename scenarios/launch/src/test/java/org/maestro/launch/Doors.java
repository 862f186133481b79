package org.maestro.launch;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** On which ports a process listens, as the system has it (Linux). */
final class Doors {
  private static final Pattern SOCKET = Pattern.compile("socket:\\[(\\d+)\\]");
  private static final String LISTENS = "0A";
  private static final Set<String> LOOPBACK =
      Set.of("0100007F", "0000000000000000FFFF00000100007F", "00000000000000000000000001000000");
  private static final int ADDRESS = 1;
  private static final int STATE = 3;
  private static final int INODE = 9;

  private Doors() {}

  /**
   * All TCP ports.
   *
   * @throws AssertionError when one is not on loopback, or when it listens to datagrams
   */
  static Set<Integer> of(long pid) throws IOException {
    Set<String> own = sockets(pid);
    Set<Integer> ports = new TreeSet<>();
    for (String kind : List.of("tcp", "tcp6", "udp", "udp6")) {
      for (String line : Files.readAllLines(Path.of("/proc/" + pid + "/net/" + kind))) {
        String[] words = line.strip().split("\\s+");
        if (words.length > INODE && own.contains(words[INODE])) {
          if (kind.startsWith("udp")) {
            throw new AssertionError("It hears datagrams: " + line);
          }
          if (words[STATE].equals(LISTENS)) {
            ports.add(port(words[ADDRESS]));
          }
        }
      }
    }
    return ports;
  }

  private static int port(String address) {
    String[] parts = address.split(":");
    if (!LOOPBACK.contains(parts[0])) {
      throw new AssertionError("It listens beyond loopback: " + address);
    }
    return Integer.parseInt(parts[1], 16);
  }

  private static Set<String> sockets(long pid) throws IOException {
    Set<String> inodes = new TreeSet<>();
    try (DirectoryStream<Path> open = Files.newDirectoryStream(Path.of("/proc/" + pid + "/fd"))) {
      for (Path descriptor : open) {
        Matcher socket = SOCKET.matcher(target(descriptor));
        if (socket.matches()) {
          inodes.add(socket.group(1));
        }
      }
    }
    return inodes;
  }

  /** One may have been closed meanwhile. */
  private static String target(Path descriptor) {
    try {
      return Files.readSymbolicLink(descriptor).toString();
    } catch (IOException closed) {
      return "";
    }
  }
}
