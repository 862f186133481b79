package org.maestro.platform.journal;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.platform.jade.PlatformStartException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads a journal's file. What a writer was at when it died is left away; a line that was certain
 * once and is damaged or missing now is an error, for who lost it could do a step twice, or forget
 * a goal.
 */
final class JournalReader {
  private static final Logger LOG = LoggerFactory.getLogger(JournalReader.class);

  private final Path file;
  private final JournalCodec codec;

  /**
   * The image that was found in a journal.
   *
   * @param generation the highest that is known
   */
  record Found(JournalImage image, int generation) {
    private static Found nothing() {
      return new Found(new JournalImage(0), 0);
    }
  }

  JournalReader(Path file, JournalCodec codec) {
    this.file = file;
    this.codec = codec;
  }

  /**
   * @param to the times in which the entries are wanted
   * @throws PlatformStartException when a line is damaged or missing
   */
  Found read(Timeline to) throws IOException {
    Optional<JournalMark> mark = mark();
    if (!Files.exists(file)) {
      mark.ifPresent(
          of ->
              LOG.warn(
                  "The journal {}, which had {} lines, is not there: the goals in it are not gone"
                      + " on with.",
                  file,
                  of.lines()));
      return Found.nothing();
    }
    String text = new String(Files.readAllBytes(file), UTF_8);
    if (text.isEmpty()) {
      mark.ifPresent(of -> requireWhole(of, of.generation(), 0));
      return Found.nothing();
    }
    return read(List.of(text.split("\n", -1)), mark, to);
  }

  private Optional<JournalMark> mark() throws IOException {
    try {
      return JournalMark.read(file);
    } catch (JournalDamage e) {
      LOG.warn(
          "{} cannot be read ({}): whether lines are missing at the end of the journal is not"
              + " known.",
          JournalMark.file(file),
          e.getMessage());
      return Optional.empty();
    }
  }

  private Found read(List<String> lines, Optional<JournalMark> mark, Timeline to) {
    boolean lastIsEnded = lines.get(lines.size() - 1).isEmpty();
    int count = lastIsEnded ? lines.size() - 1 : lines.size();
    int number = 1;
    try {
      JsonNode header = line(lines, 1);
      Timeline from = JournalDisk.timeline(header);
      int generation = JournalMark.generation(header);
      int certain = certain(mark, generation, count);
      JournalImage image = new JournalImage(JournalDisk.lastGoal(header));
      int read = 1;
      for (number = 2; number <= count; number++) {
        try {
          image.add(codec.read(line(lines, number), from, to));
          read = number;
        } catch (JournalDamage damage) {
          if (number < count || number <= certain || !damage.isIncomplete() && lastIsEnded) {
            throw damage;
          }
          LOG.warn(
              "The last line ({}) of the journal {} was not written to its end and is left away",
              number,
              file);
        }
      }
      int whole = read;
      mark.ifPresent(of -> requireWhole(of, generation, whole));
      return new Found(image, generation);
    } catch (JournalDamage damage) {
      throw damaged(number, damage, new JournalLoss(lines.subList(0, count), number));
    }
  }

  /** The line of that number, which says that it is it, and follows the one before. */
  private static JsonNode line(List<String> lines, int number) throws JournalDamage {
    JsonNode fields = JournalLine.read(lines.get(number - 1));
    int says = JournalLine.number(fields);
    if (says != number) {
      throw new JournalDamage("it says that it is line " + says, false);
    }
    if (number > 1 && !JournalLine.isAfter(fields, JournalLine.checksumOf(lines.get(number - 2)))) {
      throw new JournalDamage("it was written after another line than the one before it", false);
    }
    return fields;
  }

  /** How many lines were whole once; the mark may be of the file before this one. */
  private int certain(Optional<JournalMark> mark, int generation, int count) {
    if (mark.isEmpty() && generation > 0) {
      LOG.warn(
          "There is no {}: whether lines are missing after line {} of the journal is not known.",
          JournalMark.file(file),
          count);
    }
    return mark.filter(of -> of.generation() == generation).map(JournalMark::lines).orElse(0);
  }

  private void requireWhole(JournalMark mark, int generation, int lines) {
    if (generation < mark.generation() || generation == mark.generation() && lines < mark.lines()) {
      throw new PlatformStartException(
          "%s %s. Put the right file in its place, or delete %s to go on with the lines that are there: what the others said is lost then, goals among it."
              .formatted(
                  "The journal %s is not the one that was written last:".formatted(file),
                  generation < mark.generation()
                      ? "it is an older one"
                      : lines + 1 == mark.lines()
                          ? "line %d is missing at its end".formatted(mark.lines())
                          : "the lines %d to %d are missing at its end"
                              .formatted(lines + 1, mark.lines()),
                  JournalMark.file(file)));
    }
  }

  private PlatformStartException damaged(int line, JournalDamage damage, JournalLoss loss) {
    return new PlatformStartException(
        "The journal %s is damaged in line %d: %s%s; put the line right from a copy, or move the file away to start without the goals in it."
            .formatted(file, line, damage.getMessage(), loss.words()),
        damage);
  }
}
