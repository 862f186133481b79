package org.maestro.console.opinion;

import java.io.BufferedReader;
import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A small language model behind a server of its own, in a process of python3: SmolLM2-135M, which
 * comes in a package as the server does.
 */
public final class SmallModel implements AutoCloseable {
  private static final String SERVING = "serving ";

  private final Process process;
  private final URI base;

  private SmallModel(Process process, URI base) {
    this.process = process;
    this.base = base;
  }

  /** Waits until it serves; empty when it is not installed. */
  public static Optional<SmallModel> start() {
    try {
      Path script = Path.of(SmallModel.class.getResource("small_model.py").toURI());
      Process process =
          new ProcessBuilder("python3", script.toString())
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      BufferedReader printed = process.inputReader();
      Optional<URI> address =
          printed
              .lines()
              .filter(line -> line.startsWith(SERVING))
              .findFirst()
              .map(line -> URI.create(line.substring(SERVING.length()) + "/v1"));
      if (address.isEmpty()) {
        process.destroyForcibly();
      }
      return address.map(base -> new SmallModel(process, base));
    } catch (IOException e) {
      return Optional.empty();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  public URI base() {
    return base;
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
