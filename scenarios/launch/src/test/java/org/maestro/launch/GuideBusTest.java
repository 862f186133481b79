package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.SimpleJavaFileObject;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the guide to the bus shows can be done as it stands there. */
class GuideBusTest {

  private static final Path GUIDE = Path.of("..", "..", "docs", "guide-bus.md");

  @TempDir Path directory;

  @Test
  void theDeviceInJavaCompiles() throws IOException {
    Matcher block = Pattern.compile("(?s)```java\n(.*?)```").matcher(Files.readString(GUIDE));
    assertThat(block.find()).isTrue();
    String source =
        """
        import java.net.URI;
        import java.util.*;
        import org.maestro.rats.member.*;
        import org.maestro.rats.protocol.*;
        import org.maestro.rats.time.*;
        import org.maestro.rats.transport.*;
        class Shown {
          interface Bell { void ring(); }
          static void show(Bell bell, String description) {
        %s
          }
        }
        """
            .formatted(block.group(1));
    JavaFileObject file =
        new SimpleJavaFileObject(URI.create("string:///Shown.java"), JavaFileObject.Kind.SOURCE) {
          @Override
          public CharSequence getCharContent(boolean ignoreEncodingErrors) {
            return source;
          }
        };
    JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
    List<String> faults = new ArrayList<>();
    boolean compiled =
        compiler
            .getTask(
                null,
                null,
                fault -> faults.add(fault.toString()),
                List.of(
                    "-proc:none",
                    "-d",
                    directory.toString(),
                    "-cp",
                    System.getProperty("java.class.path")),
                null,
                List.of(file))
            .call();
    assertThat(compiled).as(String.join("\n", faults)).isTrue();
  }

  @Test
  void theCommandsThatSecureASiteDo() throws IOException {
    Path files = directory.resolve("site-files");
    List<String> commands;
    try (Stream<String> lines = Files.lines(GUIDE)) {
      commands =
          lines
              .filter(line -> line.startsWith("./maestro secure "))
              .map(line -> line.replaceFirst("#.*", "").replace("site-files", files.toString()))
              .map(line -> line.replace("/media/stick", directory.resolve("stick").toString()))
              .toList();
    }
    assertThat(commands).hasSize(6);
    Files.createDirectory(directory.resolve("stick"));
    for (String command : commands) {
      if (command.contains("--ca") && Files.exists(files.resolve("ca/key.pem"))) {
        assertThat(files.resolve("users/kettle-1/password")).isRegularFile();
        Files.move(files.resolve("ca/key.pem"), directory.resolve("stick/key.pem"));
      }
      String[] arguments = command.strip().split("\\s+");
      ByteArrayOutputStream said = new ByteArrayOutputStream();
      PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
      int code =
          Maestro.commandLine(stream, stream)
              .execute(Arrays.copyOfRange(arguments, 1, arguments.length));
      assertThat(code).as(said.toString(StandardCharsets.UTF_8)).isEqualTo(ExitCode.DONE);
    }
    assertThat(files.resolve("users/kettle-1")).doesNotExist();
    assertThat(files.resolve("users/rose/password")).isRegularFile();
    assertThat(files.resolve("users/alice/console-password")).isRegularFile();
    assertThat(files.resolve("ca/key.pem")).doesNotExist();
  }

  @Test
  void whatItNamesIsThere() throws IOException {
    Matcher link = Pattern.compile("\\]\\(([^)]+)\\)").matcher(Files.readString(GUIDE));
    while (link.find()) {
      assertThat(GUIDE.resolveSibling(link.group(1))).exists();
    }
  }

  @Test
  void aMissingFileStopsThePlatformWithOneSentence() throws IOException {
    Path files = directory.resolve("site-files");
    assertThat(execute("secure", files.toString(), "bob")).startsWith("0 ");
    Files.delete(files.resolve("users.txt"));
    assertThat(execute("run", "bob", "--port", "0", "--security", files.toString()))
        .startsWith("3 maestro: The security file ")
        .contains("users.txt is missing")
        .doesNotContain("\n");
  }

  private static String execute(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code = Maestro.commandLine(stream, stream).execute(arguments);
    return code + " " + said.toString(StandardCharsets.UTF_8).strip();
  }
}
