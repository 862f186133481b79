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
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.experiment.page.Page;

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
    assertThat(json.readValue(printed, String.class)).isEqualTo(withoutHalfCharacters(text));
  }

  /** UTF-8 has none. */
  private static String withoutHalfCharacters(String text) {
    return new String(text.getBytes(StandardCharsets.UTF_8), StandardCharsets.UTF_8);
  }

  @Test
  void aTerminalGetsLinesAndTabsOnly() {
    assertThat(printed("a\tb\nc\u001b[2J\r")).isEqualTo("a\tb\nc\\u001b[2J\\u000d");
  }

  private static String printed(String text) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintWriter terminal = VisibleWriter.on(out, false);
    terminal.print(text);
    terminal.flush();
    return out.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aPageHasItInWords() {
    String html = new Page(HOSTILE, HOSTILE, HOSTILE).text(HOSTILE).list(List.of(HOSTILE)).html();

    assertThat(html).contains(SHOWN);
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
