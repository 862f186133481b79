package org.maestro.agents.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.lang.ref.WeakReference;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.Society;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.BareJade;

/** What is left of a conversation, and what is not. */
class ConversationsTest {
  private static final Duration LONG = Duration.ofSeconds(30);

  @TempDir static Path files;
  private static BareJade jade;

  private final List<ACLMessage> replies = Collections.synchronizedList(new ArrayList<>());
  private Society society;

  @BeforeAll
  static void startJade() {
    jade = new BareJade("conversations", files);
  }

  @AfterAll
  static void endJade() {
    jade.close();
  }

  @BeforeEach
  void gather() {
    society = new Society(jade);
  }

  @AfterEach
  void disperse() {
    society.close();
  }

  /** In a home of Bob's some hundred kilobytes hung on each question about a price. */
  @Test
  void nothingIsKeptOfWhoListenedToWhatIsOver() {
    WeakReference<Object> listener = askAndHear();

    Awaitility.await()
        .atMost(LONG)
        .until(
            () -> {
              System.gc();
              return listener.get() == null;
            });
  }

  private WeakReference<Object> askAndHear() {
    List<ACLMessage> heard = new ArrayList<>();
    society.desk.request(
        ACLMessage.QUERY_REF,
        AgentNames.COORDINATOR,
        LONG,
        reply -> {
          heard.add(reply);
          replies.add(reply);
        },
        Words.content("query-ref"));
    society.await(() -> !replies.isEmpty(), LONG);
    assertThat(society.leftover()).isEmpty();
    return new WeakReference<>(heard);
  }

  @Test
  void whoWantsTheStoryOfAGoalThatThereIsNotIsToldSo() {
    society.desk.follow("G77", replies::add);
    society.await(() -> !replies.isEmpty(), LONG);

    assertThat(replies.get(0).getPerformative()).isEqualTo(ACLMessage.REFUSE);
    assertThat(replies.get(0).getContent()).contains("There is no goal G77; none was stated yet.");
  }
}
