package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.device.Host;

/** Each message between agents is seen once, whichever way it goes (M73). */
class MailWitnessTest {
  private static final String PLATFORM = "mail-witness";
  private static final Duration LIMIT = Duration.ofSeconds(30);

  /** Sends one message to each of its arguments when it begins. */
  private static final class Sender extends Agent {
    private static final long serialVersionUID = 1L;

    @Override
    protected void setup() {
      ACLMessage message = new ACLMessage(ACLMessage.QUERY_IF);
      message.setConversationId("of " + getLocalName());
      message.setContent("(raining)");
      for (Object receiver : getArguments()) {
        message.addReceiver(new AID((String) receiver, AID.ISLOCALNAME));
      }
      send(message);
    }
  }

  @Test
  void whatAnAgentOfThisProcessSendsOrIsSentIsSeenOnce(@TempDir Path files) throws Exception {
    SharedParts here = SharedParts.fresh();
    int port = Sockets.claim(0);
    AgentContainer main =
        JadeRuntime.main(
            PLATFORM, port, files, new Host(), Optional.empty(), here, Premises.usual());
    try {
      AgentContainer own = join(port, "own", files, here);
      AgentContainer elsewhere = join(port, "elsewhere", files, SharedParts.fresh());
      assertThat(here.mail().containers()).containsExactlyInAnyOrder("Main-Container", "own");
      main.acceptNewAgent("sink", new Agent()).start();
      elsewhere.acceptNewAgent("far-sink", new Agent()).start();
      List<SentMessage> seen = new CopyOnWriteArrayList<>();
      Runnable end = here.mail().listen(seen::add);

      begin(own, "near", "sink", "far-sink");
      begin(elsewhere, "far", "far-sink", "sink");

      Awaitility.await().atMost(LIMIT).until(() -> sent(seen).contains("far to sink"));
      begin(own, "last", "sink");
      Awaitility.await().atMost(LIMIT).until(() -> sent(seen).contains("last to sink"));
      assertThat(sent(seen))
          .filteredOn(way -> !way.contains("ams"))
          .containsExactlyInAnyOrder(
              "near to sink", "near to far-sink", "far to sink", "last to sink");
      assertThat(seen)
          .contains(
              new SentMessage(
                  "query-if",
                  "near@" + PLATFORM,
                  "sink@" + PLATFORM,
                  Optional.of("of near"),
                  Optional.empty(),
                  "(raining)"));

      end.run();
      List<SentMessage> later = new CopyOnWriteArrayList<>();
      here.mail().listen(later::add);
      begin(own, "unseen", "sink");
      Awaitility.await().atMost(LIMIT).until(() -> sent(later).contains("unseen to sink"));
      assertThat(sent(seen)).doesNotContain("unseen to sink");
    } finally {
      ContainerEnds.end(main);
    }
  }

  private static AgentContainer join(int port, String name, Path files, SharedParts shared) {
    return JadeRuntime.join(
        Optional.of(PLATFORM),
        "127.0.0.1",
        port,
        name,
        files,
        new JadeRuntime.Entry(Optional.empty(), false),
        new Host(),
        shared);
  }

  private static void begin(AgentContainer container, String name, String... receivers)
      throws Exception {
    Sender sender = new Sender();
    sender.setArguments(receivers);
    container.acceptNewAgent(name, sender).start();
  }

  private static List<String> sent(List<SentMessage> seen) {
    return seen.stream()
        .map(message -> local(message.sender()) + " to " + local(message.receiver()))
        .toList();
  }

  private static String local(String name) {
    return name.substring(0, name.indexOf('@'));
  }
}
