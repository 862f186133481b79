package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PipedInputStream;
import java.io.PipedOutputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.jline.terminal.Size;
import org.jline.terminal.Terminal;
import org.jline.terminal.impl.ExternalTerminal;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Lines are written on a terminal with the keys that people know. */
class TerminalKeyboardTest {
  private static final Duration LIMIT = Duration.ofSeconds(30);
  private static final String UP = "\u001bOA";
  private static final String TABULATOR = "\t";
  private static final String INTERRUPT = "\u0003";
  private static final String END = "\u0004";

  private final PipedOutputStream keys = new PipedOutputStream();
  private final ByteArrayOutputStream screen = new ByteArrayOutputStream();
  private TerminalKeyboard keyboard;

  @BeforeEach
  void open() throws IOException {
    Terminal terminal =
        new ExternalTerminal(
            "test", "xterm", new PipedInputStream(keys), screen, StandardCharsets.UTF_8);
    terminal.setSize(Size.of(80, 24));
    keyboard = new TerminalKeyboard(terminal, "Dave> ", TerminalKeyboardTest::next);
  }

  @AfterEach
  void close() {
    keyboard.close();
  }

  /** As if there were nothing but this to say. */
  private static List<String> next(String text) {
    if (text.endsWith("k")) {
      return List.of("kitchen");
    }
    return text.endsWith(" ") ? List.of("hall", "kitchen") : List.of();
  }

  private CompletableFuture<Optional<String>> reading() {
    return CompletableFuture.supplyAsync(keyboard::line);
  }

  private Optional<String> typed(String text) throws Exception {
    CompletableFuture<Optional<String>> line = reading();
    awaitPrompt();
    type(text);
    // What is completed ends in a blank.
    return line.get(LIMIT.toSeconds(), TimeUnit.SECONDS).map(String::strip);
  }

  private void awaitPrompt() {
    Awaitility.await().atMost(LIMIT).until(() -> shown().contains("Dave> "));
    screen.reset();
  }

  private void type(String text) throws IOException {
    keys.write(text.getBytes(StandardCharsets.UTF_8));
    keys.flush();
  }

  private String shown() {
    return screen.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aLineIsCompletedAndFetchedAgain() throws Exception {
    assertThat(typed("the k" + TABULATOR + "\r")).contains("the kitchen");
    assertThat(typed("I'd like it on! \"now\" \\\r")).contains("I'd like it on! \"now\" \\");
    assertThat(typed(UP + UP + "\r")).contains("the kitchen");
  }

  @Test
  void whatCouldComeNextIsShownAsOneTypes() throws Exception {
    CompletableFuture<Optional<String>> line = reading();
    awaitPrompt();
    type("the ");
    Awaitility.await().atMost(LIMIT).until(() -> shown().contains("hall"));
    type("hall\r");
    assertThat(line.get(LIMIT.toSeconds(), TimeUnit.SECONDS)).contains("the hall");
  }

  @Test
  void aLineThatIsGivenUpIsForgottenAndTheEndIsOne() throws Exception {
    CompletableFuture<Optional<String>> line = reading();
    awaitPrompt();
    type("never mind" + INTERRUPT);
    awaitPrompt();
    type("hello\r");
    assertThat(line.get(LIMIT.toSeconds(), TimeUnit.SECONDS)).contains("hello");
    assertThat(typed(END)).isEmpty();
  }

  @Test
  void whatIsToldMeanwhileBreaksNoLine() throws Exception {
    CompletableFuture<Optional<String>> line = reading();
    awaitPrompt();
    type("turn on ");
    Awaitility.await().atMost(LIMIT).until(() -> shown().contains("hall"));
    keyboard.print("Dinner is ready.\u001b[2J");
    Awaitility.await().atMost(LIMIT).until(() -> shown().contains("Dinner is ready.\\u001b[2J"));
    Awaitility.await().atMost(LIMIT).until(() -> shown().contains("Dave> turn on"));
    type("it\r");
    assertThat(line.get(LIMIT.toSeconds(), TimeUnit.SECONDS)).contains("turn on it");
  }
}
