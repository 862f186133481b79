package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;

/** What a command prints within this process. */
public final class Printed {
  private Printed() {}

  /** The command has to succeed. */
  public static String by(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    assertThat(Maestro.commandLine(stream, stream).execute(arguments)).isZero();
    return said.toString(StandardCharsets.UTF_8);
  }
}
