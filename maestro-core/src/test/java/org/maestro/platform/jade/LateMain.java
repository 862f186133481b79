package org.maestro.platform.jade;

import java.io.IOException;
import java.nio.file.Path;

/** A process that begins a main container, in its own time, and has it until its input ends. */
final class LateMain {
  private LateMain() {}

  public static void main(String[] arguments) throws IOException {
    try {
      JadeRuntime.main(arguments[0], Integer.parseInt(arguments[1]), Path.of(arguments[2]));
      System.out.println("begun");
    } catch (PlatformStartException e) {
      System.out.println(e.getMessage());
    }
    while (System.in.read() >= 0) {
      continue;
    }
    System.exit(0);
  }
}
