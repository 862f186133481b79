package org.maestro.console.references;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import org.maestro.console.documents.JsonMembers;

/** The components of a running platform, and which refers to which. */
public final class ReferencesDocument {
  private ReferencesDocument() {}

  public static JsonNode of(ReferenceGraph graph) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode components = document.node().putArray("components");
    for (Component one : graph.components()) {
      JsonMembers.in(components)
          .text("id", one.id())
          .text("faculty", one.faculty().word())
          .text("agent", one.agent())
          .text("container", one.container())
          .words("members", graph.members(one.agent()));
    }
    ArrayNode references = document.node().putArray("references");
    for (Reference one : graph.references()) {
      JsonMembers.in(references)
          .text("from", one.from())
          .text("to", one.to())
          .text("purpose", one.purpose());
    }
    return document.node();
  }
}
