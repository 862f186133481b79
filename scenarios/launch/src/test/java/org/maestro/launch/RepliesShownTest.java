package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import jade.lang.acl.ACLMessage;
import java.io.ByteArrayOutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.maestro.agents.content.Words;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.RefusalException;
import org.maestro.console.questions.Reply;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.display.VisibleWriter;
import org.maestro.text.VisibleText;

/** Answers of agents as they are shown: whatever stands in them, our lines are ours. */
class RepliesShownTest {

  @Provide
  static Arbitrary<String> words() {
    Arbitrary<String> hostile =
        Arbitraries.of(
            "\u001b[2J",
            "\u009b31m",
            "\r\n",
            "\n",
            "\u2028",
            "\u202e",
            "\u2066",
            "\u0000",
            "\"",
            "\\",
            "(",
            ")",
            "'",
            "<script>",
            "y".repeat(300),
            "FAKE",
            " ",
            "\u007f",
            "\ud83d\ude00");
    return Arbitraries.oneOf(hostile, Arbitraries.strings().ofMaxLength(5))
        .list()
        .ofMaxSize(12)
        .map(parts -> String.join("", parts));
  }

  /** As the agents' own language carries it. */
  private static List<Words> carried(String text, String number) {
    ACLMessage message = new ACLMessage(ACLMessage.REFUSE);
    message.setContent(
        Words.print(
            Words.content(
                "inform",
                Words.named("goal", Words.name("G" + number)),
                Words.named("text", Words.text(text)),
                Words.named("reason", Words.text(text)))));
    return Reply.words(message);
  }

  @Property(tries = 300)
  void aStoryHasNoLineOfOthers(@ForAll("words") String text) {
    StoryEntry entry = Reply.story(carried(text, "1").get(0));
    assertThat(entry.text()).isEqualTo(text);

    String shown = printed(out -> new StoryPrinter(out, Duration.ZERO).print(entry));

    List<String> lines = shown.lines().toList();
    assertThat(lines.get(0)).startsWith("     0.0 s  goal ");
    assertThat(lines.subList(1, lines.size())).allMatch(line -> line.startsWith(" ".repeat(21)));
    assertSeen(shown);
  }

  @Property(tries = 300)
  void aRefusalIsOneLine(@ForAll("words") String text) {
    RefusalException refused = Reply.refusal(carried(text, "1"));

    String shown = printed(out -> out.println("maestro: " + Failures.sentence(refused)));

    assertThat(shown.lines()).hasSize(1);
    assertSeen(shown);
  }

  @Property(tries = 300)
  void aTableHasALineForEachRowAndItsDocumentAllThatWasSaid(@ForAll("words") String text)
      throws JsonProcessingException {
    Table table = new Table(List.of("agent", "state"), List.of(List.of(text, "on" + text)));

    String shown = printed(table::print);
    assertThat(shown.lines()).hasSize(2);
    assertSeen(shown);

    String document =
        printed(out -> out.println(JsonMembers.empty().words("agents", List.of(text))));
    assertThat(document.lines()).hasSize(1);
    assertSeen(document);
    assertThat(new ObjectMapper().readTree(document).at("/agents/0").asText()).isEqualTo(text);
  }

  private static void assertSeen(String shown) {
    assertThat(shown).isEqualTo(VisibleText.lines(shown)).doesNotContain("\t");
  }

  private static String printed(Consumer<PrintWriter> words) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    PrintWriter terminal = VisibleWriter.on(out, false);
    words.accept(terminal);
    terminal.flush();
    return out.toString(StandardCharsets.UTF_8);
  }
}
