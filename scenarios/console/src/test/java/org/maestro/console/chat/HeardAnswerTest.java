package org.maestro.console.chat;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.ReadingRights;

/** What a conversation has of the answer to a sentence that was heard word by word. */
class HeardAnswerTest {
  private static final ReadingRights OF_ALL = new ReadingRights(Set.of("asleep"), Set.of("desk"));

  private static ObjectNode heard(String name, String text) {
    return JsonNodeFactory.instance.objectNode().put(name, text);
  }

  @Test
  void eachGoalIsUnderstood() {
    ObjectNode heard = heard("means", "(initCNP (:goal (= (level lamp) 1)))");
    heard.putArray("goals").add("G1").add("G2");

    assertThat(HeardAnswer.of(heard, OF_ALL))
        .extracting(event -> ((ChatEvent.Understood) event).goal())
        .containsExactly("G1", "G2");
  }

  @Test
  void whatIsAskedBackOrRefusedIsToldSo() {
    assertThat(HeardAnswer.of(heard("asks", "Which lamp?"), OF_ALL))
        .containsExactly(new ChatEvent.Asked("Which lamp?", List.of()));
    assertThat(HeardAnswer.of(heard("refused", "Tom may not."), OF_ALL))
        .containsExactly(new ChatEvent.Misunderstood("Tom may not.", List.of()));
  }

  @Test
  void whatIsPrivateIsNotReadByAllWhoLook() {
    ObjectNode open = heard("means", "(query-if (isIn Tom hall))").put("reply", "Yes.");
    ObjectNode closed = heard("means", "(query-if (asleep Tom))").put("reply", "Yes, he sleeps.");

    assertThat(HeardAnswer.of(open, OF_ALL)).containsExactly(new ChatEvent.Told("", "Yes."));
    assertThat(HeardAnswer.of(closed, OF_ALL))
        .singleElement()
        .extracting(ChatEvent::text)
        .asString()
        .startsWith("asleep is private in this home")
        .doesNotContain("sleeps");
  }
}
