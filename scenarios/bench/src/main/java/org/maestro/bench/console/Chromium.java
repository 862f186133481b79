package org.maestro.bench.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.maestro.assembly.SiteException;
import org.maestro.bench.TemporaryDirectory;
import org.maestro.bench.Waiting;

/** A browser without a window and with nothing remembered; it ends when it is closed. */
final class Chromium implements AutoCloseable {
  private static final List<String> NAMES =
      List.of("chromium", "chromium-browser", "google-chrome");
  private static final long END_SECONDS = 10;

  private final TemporaryDirectory profile;
  private final Process process;
  private final DevTools page;

  private Chromium(TemporaryDirectory profile, Process process, DevTools page) {
    this.profile = profile;
    this.process = process;
    this.page = page;
  }

  /**
   * @throws SiteException when there is none, or it does not start
   */
  static Chromium start() {
    Path program =
        program()
            .orElseThrow(
                () ->
                    new SiteException(
                        "There is no Chromium here, which shows the page that is measured; install"
                            + " it, as .ci/install does."));
    TemporaryDirectory profile = TemporaryDirectory.make();
    Path port = profile.path().resolve("DevToolsActivePort");
    Process process = begin(program, profile);
    try {
      Waiting.until(() -> lines(port).size() > 1, "the browser has started");
      return new Chromium(profile, process, DevTools.of(page(port)));
    } catch (IOException | RuntimeException e) {
      end(process, profile);
      throw new SiteException("The browser cannot be driven.", e);
    }
  }

  private static Process begin(Path program, TemporaryDirectory profile) {
    try {
      return new ProcessBuilder(
              program.toString(),
              "--headless=new",
              "--no-sandbox",
              "--disable-gpu",
              "--disable-dev-shm-usage",
              "--no-first-run",
              "--enable-precise-memory-info",
              "--remote-debugging-port=0",
              "--remote-allow-origins=*",
              "--user-data-dir=" + profile.path(),
              "about:blank")
          .redirectErrorStream(true)
          .redirectOutput(ProcessBuilder.Redirect.DISCARD)
          .start();
    } catch (IOException e) {
      profile.close();
      throw new SiteException("The browser cannot be started.", e);
    }
  }

  private static Optional<Path> program() {
    return Stream.of(System.getenv().getOrDefault("PATH", "").split(":"))
        .flatMap(directory -> NAMES.stream().map(name -> Path.of(directory, name)))
        .filter(Files::isExecutable)
        .findFirst();
  }

  /** What is written there so far. */
  private static List<String> lines(Path file) {
    try {
      return Files.exists(file) ? Files.readAllLines(file) : List.of();
    } catch (IOException e) {
      return List.of();
    }
  }

  private static URI page(Path port) throws IOException {
    String number = lines(port).get(0);
    JsonNode targets;
    try (InputStream told =
        URI.create("http://127.0.0.1:" + number + "/json").toURL().openStream()) {
      targets = new ObjectMapper().readTree(told);
    }
    for (JsonNode target : targets) {
      if (target.path("type").asText().equals("page")) {
        return URI.create(target.path("webSocketDebuggerUrl").asText());
      }
    }
    throw new SiteException("The browser has no page.");
  }

  DevTools page() {
    return page;
  }

  @Override
  public void close() {
    page.close();
    end(process, profile);
  }

  private static void end(Process process, TemporaryDirectory profile) {
    process.descendants().forEach(ProcessHandle::destroy);
    process.destroy();
    try {
      if (!process.waitFor(END_SECONDS, TimeUnit.SECONDS)) {
        process.destroyForcibly();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    profile.close();
  }
}
