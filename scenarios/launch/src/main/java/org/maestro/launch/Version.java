package org.maestro.launch;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The version as the build wrote it down, and what it runs on. */
final class Version implements IVersionProvider {

  @Override
  public String[] getVersion() {
    return new String[] {"MAESTRO %s on Java %s".formatted(number(), Runtime.version())};
  }

  /** The version of MAESTRO alone. */
  static String number() {
    Properties built = new Properties();
    try (InputStream text = Version.class.getResourceAsStream("version.properties")) {
      built.load(text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return built.getProperty("version");
  }
}
