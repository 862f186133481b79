package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.text.VisibleText;

/**
 * The components of a running platform and their references as a flow chart in the notation of
 * Mermaid, which most viewers of Markdown draw: components stand together by what they are for.
 */
final class MermaidDiagram {
  private final Map<String, String> nodeById = new LinkedHashMap<>();
  private final JsonNode document;

  /**
   * @param document the components, and which refers to which
   */
  MermaidDiagram(JsonNode document) {
    this.document = document;
    document
        .path("components")
        .forEach(one -> nodeById.put(one.path("id").asText(), "c" + nodeById.size()));
  }

  void print(PrintWriter out) {
    out.println("flowchart LR");
    Map<String, List<JsonNode>> componentsByFaculty = new TreeMap<>();
    document
        .path("components")
        .forEach(
            one ->
                componentsByFaculty
                    .computeIfAbsent(one.path("faculty").asText(), word -> new ArrayList<>())
                    .add(one));
    componentsByFaculty.forEach(
        (faculty, components) -> {
          out.println("  subgraph " + faculty);
          components.forEach(one -> out.println("    " + node(one)));
          out.println("  end");
        });
    document.path("references").forEach(one -> out.println("  " + arrow(one)));
  }

  private String node(JsonNode component) {
    String agent = component.path("agent").asText();
    String members = JsonRows.words(component, "members");
    boolean isNamedSo = members.equals(agent) || members.equals("-") || members.isEmpty();
    return "%s[\"%s<br/>%s%s\"]"
        .formatted(
            nodeById.get(component.path("id").asText()),
            label(agent),
            isNamedSo ? "" : "for " + label(members) + "<br/>",
            "in " + label(component.path("container").asText()));
  }

  private String arrow(JsonNode reference) {
    return "%s -->|\"%s\"| %s"
        .formatted(
            nodeById.get(reference.path("from").asText()),
            label(reference.path("purpose").asText()),
            nodeById.get(reference.path("to").asText()));
  }

  /** Names come from homes and devices, and are not to be taken for notation. */
  private static String label(String text) {
    return VisibleText.line(text)
        .replace("&", "&amp;")
        .replace("\"", "&quot;")
        .replace("<", "&lt;")
        .replace(">", "&gt;");
  }
}
