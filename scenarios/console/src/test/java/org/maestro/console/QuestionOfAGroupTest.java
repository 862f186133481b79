package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** A group agent's own script asks, and is answered where those of the central agent are. */
@Isolated("its time is wall time, which others beside it would take")
class QuestionOfAGroupTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final String PORCH =
      """

      home:porch a maestro:GroupAgent ; rdfs:label "the porch"@en ; maestro:member home:lamp-b1 ;
        maestro:plans false ; maestro:pursues "(brighten)" .
      home:brighten a maestro:Script ;
        maestro:body \"""(seq (ask Bob "How bright?" ?level double) (wait 1)
          (ask Bob "Shall it stay?" ?stay boolean) (say Bob "It is" ?level "now."))\""" .
      """;

  private static JsonNode goal(ServedHome home) throws Exception {
    for (JsonNode goal : home.get("/goals").document().path("goals")) {
      if (goal.path("id").asText().equals("porch-1")) {
        return goal;
      }
    }
    return home.get("/goals").document().path("none");
  }

  @Test
  void isAnsweredByTheOperationAndInTheChat() throws Exception {
    try (ServedHome home = ServedHome.startWithMore(PORCH)) {
      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> goal(home).path("detail").asText().contains("to \"How bright?\""));

      ServedHome.Answer wrong = home.post("/questions/porch-1.1/answer", "{\"text\":\"very\"}");
      assertThat(wrong.status()).isEqualTo(400);
      assertThat(wrong.problem())
          .isEqualTo("porch-1.1 is not answered by \"very\"; write a number, such as 21.5.");
      assertThat(home.post("/questions/porch-1.1/answer", "{\"text\":\"0.5\"}").status())
          .isEqualTo(204);
      ServedHome.Answer again = home.post("/questions/porch-1.1/answer", "{\"text\":\"0.5\"}");
      assertThat(again.status()).isEqualTo(404);
      assertThat(again.problem()).startsWith("There is no open question porch-1.1;");

      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> goal(home).path("detail").asText().contains("to \"Shall it stay?\""));
      home.post("/chat", "{\"person\":\"Bob\",\"room\":\"room-b\",\"text\":\"yes\"}");
      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> goal(home).path("state").asText().equals("achieved"));
      assertThat(home.get("/chat").document().toString())
          .contains("That is the answer to: Shall it stay?", "It is 0.5 now.");
    }
  }
}
