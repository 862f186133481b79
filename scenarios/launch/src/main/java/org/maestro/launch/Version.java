package org.maestro.launch;

import java.io.IOException;
import java.io.InputStream;
import java.util.Properties;
import picocli.CommandLine.IVersionProvider;

/** The version as the build wrote it down, and what it runs on. */
final class Version implements IVersionProvider {

  @Override
  public String[] getVersion() throws IOException {
    Properties built = new Properties();
    try (InputStream text = Version.class.getResourceAsStream("version.properties")) {
      built.load(text);
    }
    return new String[] {
      "MAESTRO %s on Java %s".formatted(built.getProperty("version"), Runtime.version())
    };
  }
}
