package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

class TopicsTest {

  private final Topics topics = new Topics("bob");

  @Test
  void areThoseOfTheAsyncApiDocument() throws IOException {
    Set<String> documented = new TreeSet<>();
    for (JsonNode channel : Schemas.document("asyncapi.json").get("channels")) {
      documented.add(
          channel
              .get("address")
              .textValue()
              .replace("{site}", "bob")
              .replaceAll("\\{([a-z]+)}", "$1"));
    }
    assertThat(documented)
        .containsExactlyInAnyOrder(
            topics.call("from"),
            "rats/1/bob/call",
            topics.result("to", "member"),
            topics.bareResult(),
            topics.progress("to", "member"),
            topics.status("member"),
            topics.description("member"),
            topics.state("member"),
            topics.observation("member", "feature"),
            topics.stream("member", "feature"),
            topics.controllerStatus("controller"),
            topics.verdict("controller", "member"));
  }

  @Test
  void theAsyncApiDocumentPointsAtSchemasThatExist() throws IOException {
    for (JsonNode message : Schemas.document("asyncapi.json").at("/components/messages")) {
      JsonNode reference = message.at("/payload/schema/$ref");
      if (!reference.isMissingNode()) {
        assertThat(Schemas.document(reference.textValue().substring(2)).get("title")).isNotNull();
      }
    }
  }

  @Test
  void tellWhoIsMeant() {
    assertThat(topics.callerOf("rats/1/bob/call/cca")).contains("cca");
    assertThat(topics.callerOf("rats/1/bob/call")).isEmpty();
    assertThat(topics.memberOf(topics.observation("cam-a", "look"))).contains("cam-a");
    assertThat(topics.memberOf("rats/1/other/member/x/status")).isEmpty();
    assertThat(topics.senderOf(topics.result("cca", "rose"))).contains("rose");
    assertThat(topics.senderOf(topics.bareResult())).isEmpty();
  }

  @Test
  void tellWhichControllerIsMeant() {
    assertThat(topics.controllerOf(topics.controllerStatus("cca"))).contains("cca");
    assertThat(topics.controllerOf("rats/1/bob/controller/cca")).contains("cca");
    assertThat(topics.controllerOf(topics.status("rose"))).isEmpty();
    assertThat(topics.controllerOf("rats/1/other/controller/cca/status")).isEmpty();
  }

  @Test
  void tellWhoSpeaks() {
    assertThat(topics.speakerOf(topics.call("cca"))).isEqualTo("cca");
    assertThat(topics.speakerOf(topics.state("rose"))).isEqualTo("rose");
    assertThat(topics.speakerOf(topics.controllerStatus("cca"))).isEqualTo("cca");
    assertThat(topics.speakerOf(topics.result("cca", "rose"))).isEqualTo("rose");
    assertThat(topics.speakerOf(topics.progress("cca", "rose"))).isEqualTo("rose");
    for (String nobody : List.of("rats/1/bob/call", topics.bareResult(), "rats/1/other/call/cca")) {
      assertThat(topics.speakerOf(nobody)).isEqualTo(nobody);
    }
  }

  @Test
  void areHeardByTheirFilters() {
    assertThat(topics.calls()).isEqualTo("rats/1/bob/call/#");
    assertThat(topics.results("cca")).isEqualTo("rats/1/bob/result/cca/#");
    assertThat(topics.progresses("cca")).isEqualTo("rats/1/bob/progress/cca/#");
    assertThat(topics.statuses()).isEqualTo("rats/1/bob/member/+/status");
    assertThat(topics.descriptions()).isEqualTo("rats/1/bob/member/+/description");
    assertThat(topics.states()).isEqualTo("rats/1/bob/member/+/state");
    assertThat(topics.observations()).isEqualTo("rats/1/bob/member/+/observation/+");
    assertThat(topics.controllerStatuses()).isEqualTo("rats/1/bob/controller/+/status");
  }

  @Test
  void refuseASiteThatIsNoLevel() {
    for (String site : new String[] {"", "a/b", "+", "-a", "a".repeat(64)}) {
      assertThatThrownBy(() -> new Topics(site))
          .isInstanceOf(IllegalArgumentException.class)
          .hasMessage(
              "'%s' is no site name: letters, digits, '.', '_' and '-', at most 63, a letter or digit first",
              site);
    }
    assertThat(new Topics("a".repeat(63)).site()).hasSize(63);
  }
}
