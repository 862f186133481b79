package org.maestro.display;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.joran.JoranConfigurator;
import ch.qos.logback.classic.util.LogbackMDCAdapter;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.experiment.page.Page;
import org.maestro.text.VisibleText;

/** What a terminal, a log or a page would obey is shown. */
class VisibleTextTest {
  private static final String HOSTILE = "a\u001b[31mred\u009b2J\u0007\r\nReached.\u202eevil\u007f";
  private static final String SHOWN =
      "a\\u001b[31mred\\u009b2J\\u0007\\u000d\\u000aReached.\\u202eevil\\u007f";

  @TempDir static Path directory;

  @Property
  void whatIsSeenIsUnchangedAndAllElseIsGone(@ForAll String text) {
    String line = VisibleText.line(text);

    assertThat(line.chars()).noneMatch(Character::isISOControl);
    if (text.chars().noneMatch(c -> Character.isISOControl(c) || Character.getType(c) >= 13)) {
      assertThat(line).isEqualTo(text);
    }
  }

  @Property
  void aDocumentThatIsPrintedIsTheSameDocument(@ForAll String text) throws JsonProcessingException {
    ObjectMapper json = new ObjectMapper();
    String printed = printed(json.writeValueAsString(text));

    assertThat(printed.chars()).noneMatch(Character::isISOControl);
    assertThat(json.readValue(printed, String.class)).isEqualTo(text);
  }

  @Test
  void whatHidesOrIsHalfIsShownAndWhatIsWrittenSoStays() {
    assertThat(VisibleText.line("a\u202eb\u2066c\u200bd\ufeffe\udb40\udc41f\ud800g"))
        .isEqualTo("a\\u202eb\\u2066c\\u200bd\\ufeffe\\udb40\\udc41f\\ud800g");
    String written = "K\u00fcche \ud83d\udc69\u200d\ud83d\udd2c \u05d0\u05d1 \u0646\u200c\u0647";
    assertThat(VisibleText.line(written)).isEqualTo(written);
  }

  /** Nobody's words begin a line, however they come to be printed. */
  @Test
  void wordsOfOthersBeginNoLine() {
    String forged = "no\nmaestro: Reached.";
    assertThat(printed(out -> out.println(forged)))
        .isEqualTo("no\\u000amaestro: Reached." + System.lineSeparator());
    assertThat(printed(out -> out.printf("%s, %d%n", forged, 3)))
        .isEqualTo("no\\u000amaestro: Reached., 3" + System.lineSeparator());
    assertThat(printed(out -> out.printf(Locale.ROOT, "%s %.1f%n", forged, 3.0)))
        .isEqualTo("no\\u000amaestro: Reached. 3.0" + System.lineSeparator());
  }

  @Test
  void aTerminalGetsLinesAndTabsOnly() {
    assertThat(printed("a\tb\nc\u001b[2J\r")).isEqualTo("a\tb\nc\\u001b[2J\\u000d");
  }

  private static String printed(String text) {
    return printed(terminal -> terminal.print(text));
  }

  private static String printed(Consumer<PrintWriter> words) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintWriter terminal = VisibleWriter.on(out, false);
    words.accept(terminal);
    terminal.flush();
    return out.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aPageHasItInWords() {
    String html = new Page(HOSTILE, HOSTILE, HOSTILE).text(HOSTILE).list(List.of(HOSTILE)).html();

    assertThat(html).contains(SHOWN);
    assertThat(new Page("a", "b", "c").text("\"><script>alert(1)</script>").html())
        .doesNotContain("<script>")
        .contains("&quot;&gt;&lt;script&gt;");
    assertThat(html.chars().filter(c -> c != '\n')).noneMatch(Character::isISOControl);
  }

  /** The log as users have it. */
  @Test
  void aLogHasOneLineForOneMessage() throws Exception {
    Path file = directory.resolve("maestro.log");
    LoggerContext context = new LoggerContext();
    context.setMDCAdapter(new LogbackMDCAdapter());
    context.putProperty("maestro.log", file.toString());
    JoranConfigurator configurator = new JoranConfigurator();
    configurator.setContext(context);
    configurator.doConfigure(VisibleTextTest.class.getResource("/logback.xml"));

    context.getLogger("any").info("{} did not answer", HOSTILE);
    context.getLogger("any").info("It broke", new IOException(HOSTILE));
    context.stop();

    String log = Files.readString(file);
    assertThat(log.lines().toList().get(0)).endsWith(SHOWN + " did not answer");
    assertThat(log.lines().toList().get(1)).endsWith("It broke");
    assertThat(log).contains("java.io.IOException: a\\u001b[31m");
    assertThat(log.split("java.io.IOException", -1)).hasSize(2);
    assertThat(log.chars().filter(c -> c != '\n' && c != '\t')).noneMatch(Character::isISOControl);
  }
}
