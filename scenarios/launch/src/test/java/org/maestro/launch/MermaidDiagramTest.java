package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;

/** A running platform's components as a flow chart (A39). */
class MermaidDiagramTest {
  private static final String DOCUMENT =
      """
      {"components": [
        {"id": "CCA/cognition", "faculty": "cognition", "agent": "CCA",
         "container": "Main-Container", "members": []},
        {"id": "glim/action", "faculty": "action", "agent": "glim",
         "container": "lights", "members": ["lamp-1", "a\\"] --> b"]}],
       "references": [{"from": "CCA/cognition", "to": "glim/action", "purpose": "calls"}]}
      """;

  @Test
  void componentsStandByWhatTheyAreForAndNamesAreNoNotation() throws Exception {
    StringWriter drawn = new StringWriter();
    try (PrintWriter out = new PrintWriter(drawn)) {
      new MermaidDiagram(new ObjectMapper().readTree(DOCUMENT)).print(out);
    }

    assertThat(drawn.toString().lines())
        .containsExactly(
            "flowchart LR",
            "  subgraph action",
            "    c1[\"glim<br/>for lamp-1 a&quot;] --&gt; b<br/>in lights\"]",
            "  end",
            "  subgraph cognition",
            "    c0[\"CCA<br/>in Main-Container\"]",
            "  end",
            "  c0 -->|\"calls\"| c1");
  }
}
