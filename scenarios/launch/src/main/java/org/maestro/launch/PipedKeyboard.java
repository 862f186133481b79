package org.maestro.launch;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Optional;

/** Lines that come in as they are, from a file, another program, or a terminal that can no more. */
final class PipedKeyboard implements Keyboard {
  private final BufferedReader in;
  private final PrintWriter out;

  PipedKeyboard(InputStream in, PrintWriter out) {
    this.in = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8));
    this.out = out;
  }

  @Override
  public Optional<String> line() {
    try {
      return Optional.ofNullable(in.readLine());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void print(String line) {
    out.println(line);
    out.flush();
  }

  @Override
  public boolean isWrittenByHand() {
    return false;
  }

  @Override
  public void close() {
    // What it reads from and writes to belongs to the process.
  }
}
