package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** The example of a device in C, in a process of its own. */
final class BellInC implements AutoCloseable {
  static final String ID = "bell-1";

  private static final Path SOURCES = Path.of("..", "docs", "examples", "bell");

  private final Process process;
  private final Path said;

  private BellInC(Process process, Path said) {
    this.process = process;
    this.said = said;
  }

  /** Makes the program, which ends at its first fault where the compiler can have it watched. */
  static Path compiled(Path directory) throws IOException, InterruptedException {
    List<String> watched = List.of("-fsanitize=address,undefined", "-fno-sanitize-recover=all");
    if (!compile(directory, watched).isEmpty()) {
      assertThat(compile(directory, List.of())).isEmpty();
    }
    return directory.resolve("bell");
  }

  /** What the compiler says; nothing when all is right. */
  private static String compile(Path directory, List<String> more)
      throws IOException, InterruptedException {
    List<String> command =
        new ArrayList<>(List.of("cc", "-std=c11", "-Os", "-Wall", "-Wextra", "-Werror", "-g"));
    command.addAll(more);
    command.addAll(List.of("-o", directory.resolve("bell").toString()));
    try (Stream<Path> files = Files.list(SOURCES)) {
      files.map(Path::toString).filter(name -> name.endsWith(".c")).forEach(command::add);
    }
    Process compiler = new ProcessBuilder(command).redirectErrorStream(true).start();
    String said = new String(compiler.getInputStream().readAllBytes(), UTF_8);
    return compiler.waitFor() == 0 ? said : said + "\nThe compiler failed: " + command;
  }

  static BellInC start(Path program, URI broker, String site) throws IOException {
    Path said = Files.createTempFile(program.toAbsolutePath().getParent(), "said", "");
    return new BellInC(
        new ProcessBuilder(
                program.toString(), broker.getHost(), String.valueOf(broker.getPort()), site)
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start(),
        said);
  }

  boolean isAlive() {
    return process.isAlive();
  }

  /** What it has printed until now, one line for each stroke. */
  List<String> said() throws IOException {
    return Files.readAllLines(said);
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
