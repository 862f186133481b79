package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
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
            topics.controllerStatus("controller"));
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
  void refuseASiteThatIsNoLevel() {
    for (String site : new String[] {"", "a/b", "+", "-a"}) {
      assertThatThrownBy(() -> new Topics(site)).isInstanceOf(IllegalArgumentException.class);
    }
  }
}
