package org.maestro.console.traffic;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.platform.jade.SentMessage;

/** Messages make up conversations, whose state is what they tell of it and no more. */
class ConversationTest {
  private final MailTraffic mail =
      new MailTraffic(
          "home", message -> message.content().equals("poll"), () -> Duration.ZERO, List::of);

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a>b request                                   | open",
        "a>b request, b>a agree                        | open",
        "a>b request, b>a agree, b>a inform            | done",
        "a>b request, b>a agree, b>a confirm           | open",
        "a>b request, b>a refuse                       | refused",
        "a>b request, b>a failure                      | failed",
        "a>b request, b>a inform, a>b cancel           | cancelled",
        "a>b subscribe, b>a agree, b>a inform          | open",
        "a>b subscribe, b>a refuse                     | refused",
        "a>b cfp, a>c cfp, b>a propose, c>a refuse     | open",
        "a>b cfp, a>c cfp, b>a refuse, c>a refuse      | refused",
        "a>b cfp, a>c cfp, b>a propose, c>a propose, a>b reject-proposal, a>c accept-proposal | open",
        "a>b cfp, b>a propose, a>b accept-proposal, b>a inform | done",
        "a>b inform                                    | done"
      })
  void itIsOpenUntilEachHasSaidTheLastWord(String said, String state) {
    for (String one : said.split(", ")) {
      mail.sent(message(one.substring(0, 1), one.substring(2, 3), one.substring(4), "x", "text"));
    }

    assertThat(mail.all().at("/conversations/0/state").asText()).isEqualTo(state);
  }

  @Test
  void eachHasItsOwnAndWhatTheConsoleAsksIsLeftOut() {
    mail.sent(message("a", "b", "request", "one", "first"));
    mail.sent(message("desk", "b", "query-ref", "two", "poll"));
    mail.sent(message("b", "desk", "inform", "two", "answer"));
    mail.sent(message("c", "d", "inform", null, "no id"));
    mail.sent(message("d", "c", "inform", null, "no id either"));
    mail.sent(message("b", "a", "inform", "one", "x".repeat(20_000)));

    JsonNode all = mail.all();
    assertThat(all.path("conversations").findValuesAsText("id")).containsExactly("C1", "C2");
    assertThat(all.at("/conversations/0/messages").asInt()).isEqualTo(2);
    assertThat(all.at("/conversations/1/conversation").isNull()).isTrue();
    assertThat(mail.between(2, mail.latest()).path("conversations")).hasSize(2);
    assertThat(mail.between(3, mail.latest()).path("conversations").findValuesAsText("id"))
        .containsExactly("C1");
    JsonNode answer = mail.conversation("C1").orElseThrow().at("/sequence/1");
    assertThat(answer.path("content").asText()).hasSize(16_000);
    assertThat(answer.path("characters").asInt()).isEqualTo(20_000);
    assertThat(answer.path("shortened").asBoolean()).isTrue();
    assertThat(mail.conversation("C9")).isEmpty();
  }

  @Test
  void whatIsOldIsGone() {
    for (int i = 0; i < 5_000; i++) {
      mail.sent(message("a", "b", "inform", "c" + i, "text"));
    }

    assertThat(mail.conversation("C1")).isEmpty();
    assertThat(mail.all().path("conversations")).hasSize(3_000);
    assertThat(mail.all().path("oldest").asInt()).isEqualTo(2_001);
  }

  private static SentMessage message(
      String from, String to, String performative, String conversation, String content) {
    return new SentMessage(
        performative,
        from + "@home",
        to + "@home",
        Optional.ofNullable(conversation),
        Optional.of("fipa-request"),
        content);
  }
}
