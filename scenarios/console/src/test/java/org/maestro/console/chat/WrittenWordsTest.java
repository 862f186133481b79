package org.maestro.console.chat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.assembly.LocalSite;
import org.maestro.dialogue.Reading;
import org.maestro.dialogue.Utterance;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** What is written is read as a goal, a question, a part of a goal, or not at all. */
class WrittenWordsTest {
  private static final WrittenWords WORDS = new WrittenWords(home());

  private static Home home() {
    try (InputStream text =
        Objects.requireNonNull(LocalSite.class.getResourceAsStream("/homes/bob.ttl"))) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static Reading read(String text) {
    return WORDS.read(new Utterance("Bob", "room-a", text, Optional.empty()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(nextTo Cup Bob)                  | (nextTo Cup Bob)",
        "(canSee ?who Bob)                 | (canSee ?who Bob)",
        "nextTo Cup Bob                    | (nextTo Cup Bob)",
        "the cup is next to me             | (nextTo Cup Bob)",
        "The cup next to Bob, please.      | (nextTo Cup Bob)",
        "next to cup bob                   | (nextTo Cup Bob)",
        "open the door between A and B     | (open door-ab)",
        "the cup in room B                 | (in Cup zone-b)",
        "illuminance here 100              | (>= (illuminance zone-a) 100)",
        "illuminance of room B at least 72 | (>= (illuminance zone-b) 72)"
      })
  void whatIsToBeSoIsAGoal(String text, String goal) {
    assertThat(read(text)).isEqualTo(new Reading.Goal(goal));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "? (in Cup ?where)      | (in Cup ?where)",
        "(in Cup ?where)?       | (in Cup ?where)",
        "? in Cup               | (in Cup ?p)",
        "is the cup next to me? | (nextTo Cup Bob)",
        "illuminance here?      | (illuminance zone-a)",
        "illuminance here 50 ?  | (>= (illuminance zone-a) 50)"
      })
  void aQuestionMarkMakesItAQuestion(String text, String question) {
    assertThat(read(text)).isEqualTo(new Reading.Question(question));
  }

  @Test
  void whatLacksItsLastPartIsUnfinished() {
    assertThat(read("nextTo Cup")).isEqualTo(new Reading.Unfinished("nextTo Cup", "Thing"));
    assertThat(read("illuminance here")).isEqualTo(new Reading.Unfinished("illuminance here", ""));
    assertThat(WORDS.choices("Zone")).containsExactlyInAnyOrder("zone-a", "zone-b");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(nextT Cup Bob)     | write nextTo, if that is meant | (nextTo Cup Bob)",
        "nextT Cup Bob       | I do not know the word \"nextT\" | nextTo Cup Bob",
        "bring the cup to me | I do not know the word \"bring\" | (nextTo Cup Bob)",
        "(nextTo Cup         | was expected                   |",
        "the cup             | No word of that says what is to be so |",
        "nextTo Cup Bob rose | names 3 things, and nextTo is said of 2 |",
        "nextTo in Cup Bob   | says several things at once    |",
        "' '                 | Say what is to be so           |",
        "?                   | Say what is to be so           |"
      })
  void whatIsNotUnderstoodIsASentenceWithWhatIsNear(String text, String why, String near) {
    assertThat(read(text)).isInstanceOf(Reading.Unclear.class);
    Reading.Unclear unclear = (Reading.Unclear) read(text);
    assertThat(unclear.why()).contains(why);
    if (near != null) {
      assertThat(unclear.near()).contains(near);
    }
  }
}
