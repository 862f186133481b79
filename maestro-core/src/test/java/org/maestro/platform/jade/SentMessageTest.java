package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.deployment.AgentStart;

/** What those see of messages between agents who look on. */
class SentMessageTest {
  @Test
  void thePasswordOfARegistrationIsToldToNobodyWhoLooksOn() {
    ACLMessage message = new ACLMessage(ACLMessage.REQUEST);
    message.setContent(
        Words.print(
            StartWords.registration(
                AgentStart.of("lamp-9", "lights"),
                Optional.of(new StartWords.Shown("ann", "se\"cr\\et) ")))));
    String seen =
        SentMessage.of(new AID("lamp-9@home", AID.ISGUID), message, new AID("CCA@home", AID.ISGUID))
            .content();
    assertThat(message.getContent()).contains("se");
    assertThat(seen)
        .contains("(:person \"ann\") (:password \"...\")")
        .doesNotContain("se\\\"", "cr", "et)");
  }
}
