package org.maestro.agents;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.maestro.platform.BareJade;

/** JADE for a class of tests, and a society of its own for each of them, one after the other. */
public final class SocietyExtension
    implements BeforeAllCallback, AfterAllCallback, BeforeEachCallback, AfterEachCallback {
  private final String platform;
  private Path files;
  private BareJade jade;
  private Society society;

  public SocietyExtension(String platform) {
    this.platform = platform;
  }

  public BareJade jade() {
    return jade;
  }

  /** That of the test that runs. */
  public Society society() {
    return society;
  }

  @Override
  public void beforeAll(ExtensionContext context) throws IOException {
    files = Files.createTempDirectory(platform);
    jade = new BareJade(platform, files);
  }

  @Override
  public void beforeEach(ExtensionContext context) {
    society = new Society(jade);
  }

  @Override
  public void afterEach(ExtensionContext context) {
    society.close();
  }

  @Override
  public void afterAll(ExtensionContext context) throws IOException {
    jade.close();
    try (Stream<Path> all = Files.walk(files)) {
      for (Path file : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.deleteIfExists(file);
      }
    }
  }
}
