package org.maestro.platform.journal;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.AnswerLog;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Respondent;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.maestro.storage.StorageFault;
import org.maestro.storage.WritingAside;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers to questions of scripts, the latest in memory and all of them in a file of JSON lines,
 * where there is one. Any thread may use it.
 */
public final class AnswerFile implements AnswerLog, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(AnswerFile.class);
  private static final String NAME = "answers.jsonl";
  private static final int MOST = 20_000;

  private final Optional<Path> file;
  private final WritingAside aside;
  private final ObjectMapper json = new ObjectMapper();

  /** Guarded by this. */
  private final Deque<GivenAnswer> latest = new ArrayDeque<>();

  /** Whether the last line may have been cut short; the writing thread's. */
  private boolean torn;

  private AnswerFile(Optional<Path> file, WritingAside aside) {
    this.file = file;
    this.aside = aside;
  }

  /** One that forgets with its process. */
  public static AnswerFile inMemory() {
    return new AnswerFile(Optional.empty(), WritingAside.atOnce(""));
  }

  /**
   * One that goes on with what was kept before. A line that cannot be read is left out, and stays
   * in the file.
   *
   * @param directory which nobody else uses
   * @throws PlatformStartException when the file is there and cannot be read
   */
  public static AnswerFile open(Path directory, Clock clock) {
    Path file = directory.resolve(NAME);
    String subject = "Answers to scripts";
    AnswerFile opened =
        new AnswerFile(
            Optional.of(file),
            clock.isStepped() ? WritingAside.atOnce(subject) : WritingAside.begin(subject));
    try {
      opened.read(file);
      return opened;
    } catch (IOException e) {
      opened.close();
      throw new PlatformStartException(
          "The answers in %s cannot be read (%s); mend that, or name another directory."
              .formatted(file, StorageFault.words(e)),
          e);
    }
  }

  private void read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return;
    }
    String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    torn = !text.isEmpty() && !text.endsWith("\n");
    int number = 0;
    for (String line : text.split("\n")) {
      number++;
      if (line.isBlank()) {
        continue;
      }
      Optional<GivenAnswer> answer = answer(line);
      answer.ifPresent(this::remember);
      if (answer.isEmpty()) {
        LOG.warn("Line {} of {} is damaged and left out.", number, file);
      }
    }
  }

  @Override
  public void keep(GivenAnswer answer, Runnable then) {
    remember(answer);
    if (file.isEmpty()) {
      then.run();
      return;
    }
    byte[] line = (line(answer) + "\n").getBytes(StandardCharsets.UTF_8);
    aside.add(line.length, () -> write(file.get(), line), then);
  }

  private synchronized void remember(GivenAnswer answer) {
    latest.addLast(answer);
    if (latest.size() > MOST) {
      latest.removeFirst();
    }
  }

  /** The latest, in the order in which they were given. */
  public synchronized List<GivenAnswer> latest() {
    return List.copyOf(latest);
  }

  /** A line that was cut short before is ended first. */
  private void write(Path to, byte[] line) throws IOException {
    byte[] end = torn ? "\n".getBytes(StandardCharsets.UTF_8) : new byte[0];
    torn = true;
    byte[] whole = new byte[end.length + line.length];
    System.arraycopy(end, 0, whole, 0, end.length);
    System.arraycopy(line, 0, whole, end.length, line.length);
    Files.write(
        to, whole, StandardOpenOption.CREATE, StandardOpenOption.APPEND, StandardOpenOption.DSYNC);
    torn = false;
  }

  private String line(GivenAnswer answer) {
    ObjectNode line =
        json.createObjectNode()
            .put("at", answer.at().toString())
            .put("script", answer.script())
            .put("goal", answer.goal())
            .put("part", answer.part())
            .put("to", answer.to())
            .put("by", answer.by().caller());
    answer.by().person().ifPresent(person -> line.put("person", person));
    return line.put("question", answer.question()).put("answer", answer.answer()).toString();
  }

  private Optional<GivenAnswer> answer(String line) {
    try {
      JsonNode node = json.readTree(line);
      return Optional.of(
          new GivenAnswer(
              Instant.parse(node.path("at").asText()),
              node.path("script").asText(),
              node.path("goal").asText(),
              node.path("part").asText(),
              node.path("to").asText(),
              new Respondent(
                  node.path("by").asText(), Optional.ofNullable(node.path("person").textValue())),
              node.path("question").asText(),
              node.path("answer").asText()));
    } catch (JsonProcessingException | DateTimeParseException damaged) {
      return Optional.empty();
    }
  }

  /** What was taken is written, or left away when the disk does not take it in time. */
  @Override
  public void close() {
    aside.close();
  }
}
