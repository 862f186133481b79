package org.maestro.console.api;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.access.Access;
import org.maestro.console.access.Session;
import org.maestro.console.access.Visit;
import org.maestro.console.documents.JsonMembers;
import org.maestro.rats.security.Role;

/** The operations by which a browser begins a session and ends it. */
public final class SessionOperations {
  private static final String PATH = "/session";
  private static final String SESSION = "session";

  private final Access access;

  public SessionOperations(Access access) {
    this.access = access;
  }

  public List<Operation> operations() {
    return List.of(
        Operation.get(
                PATH,
                SESSION,
                "Who asks, and what she may.",
                SESSION,
                request -> answer(request.visit()))
            .byAnybody(),
        Operation.asking(
                Operation.Method.POST,
                PATH,
                "signIn",
                "Begins a session; the browser brings it with each further request.",
                SESSION,
                this::signIn)
            .byAnybody()
            .taking("session-request"),
        Operation.order(
                Operation.Method.DELETE, PATH, "signOut", "Ends the session.", this::signOut)
            .byAnybody());
  }

  private CompletableFuture<JsonNode> signIn(Operation.Request request) {
    Visit begun =
        access.signIn(
            request.body().path("name").asText(),
            request.body().path("password").asText(),
            request.address());
    request.remember(begun.session().map(Session::token));
    return answer(begun);
  }

  private CompletableFuture<?> signOut(Operation.Request request) {
    access.signOut(request.visit());
    request.remember(Optional.empty());
    return CompletableFuture.completedFuture(request.visit());
  }

  private CompletableFuture<JsonNode> answer(Visit visit) {
    return CompletableFuture.completedFuture(
        JsonMembers.empty()
            .truth("secured", access.isSecured())
            .text("person", visit.person())
            .text("role", visit.role().map(Role::word))
            .text("csrf", visit.session().map(Session::csrf))
            .node());
  }
}
