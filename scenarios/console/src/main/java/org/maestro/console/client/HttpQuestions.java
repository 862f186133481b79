package org.maestro.console.client;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.HttpURLConnection;
import java.net.URI;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import javax.net.ssl.HttpsURLConnection;
import org.maestro.console.api.Api;
import org.maestro.console.questions.AgentOrder;
import org.maestro.console.questions.Questions;
import org.maestro.console.questions.RefusalException;
import org.maestro.rats.transport.Credentials;

/**
 * Asks a platform by its console. Each question blocks the thread that asks, and its answer is
 * there when it returns; where no console answers it throws an {@link UnreachableConsoleException}.
 */
public final class HttpQuestions implements Questions {
  /** As long as the server itself waits for agents, and a little longer. */
  private static final int ANSWER_WITHIN_MILLIS = 25_000;

  private static final int CONNECT_MILLIS = 2_000;
  private static final int FIRST_BAD_STATUS = 400;

  private final URI console;
  private final Optional<Credentials> person;

  /** Of an open site. */
  public HttpQuestions(URI console) {
    this(console, Optional.empty());
  }

  /**
   * @param person of a secured site as whom to ask
   */
  public HttpQuestions(URI console, Optional<Credentials> person) {
    this.console = console;
    this.person = person;
  }

  @Override
  public CompletableFuture<JsonNode> goals() {
    return get("/goals");
  }

  @Override
  public CompletableFuture<JsonNode> agents() {
    return get("/agents");
  }

  @Override
  public CompletableFuture<JsonNode> containers() {
    return get("/containers");
  }

  @Override
  public CompletableFuture<JsonNode> references() {
    return get("/references");
  }

  @Override
  public CompletableFuture<JsonNode> words() {
    return get("/words");
  }

  @Override
  public CompletableFuture<JsonNode> know(String question) {
    return get("/knowledge?question=" + encoded(question));
  }

  @Override
  public CompletableFuture<JsonNode> story(String goal, OptionalInt plan, OptionalInt step) {
    StringBuilder path = new StringBuilder("/goals/" + encoded(goal) + "/story");
    step.ifPresent(number -> path.append("?step=").append(number));
    plan.ifPresent(number -> path.append(step.isPresent() ? "&plan=" : "?plan=").append(number));
    return get(path.toString());
  }

  @Override
  public CompletableFuture<JsonNode> trace(String goal) {
    return get("/goals/" + encoded(goal) + "/trace");
  }

  @Override
  public CompletableFuture<Void> cancel(String goal) {
    return request("DELETE", "/goals/" + encoded(goal), Optional.empty()).thenAccept(nothing -> {});
  }

  @Override
  public CompletableFuture<Void> answer(String question, String text, Optional<String> who) {
    ObjectNode body = JsonNodeFactory.instance.objectNode().put("text", text);
    who.ifPresent(name -> body.put("person", name));
    return request("POST", "/questions/" + encoded(question) + "/answer", Optional.of(body))
        .thenAccept(nothing -> {});
  }

  @Override
  public CompletableFuture<JsonNode> answers(Optional<String> script) {
    return get("/answers" + script.map(name -> "?script=" + encoded(name)).orElse(""));
  }

  @Override
  public CompletableFuture<JsonNode> day(String who, Optional<String> date) {
    return get("/days/" + encoded(who) + date.map(day -> "?date=" + encoded(day)).orElse(""));
  }

  @Override
  public CompletableFuture<JsonNode> say(
      String person, String room, String text, Optional<String> language) {
    ObjectNode body = JsonNodeFactory.instance.objectNode();
    body.put("person", person).put("room", room).put("text", text);
    language.ifPresent(tag -> body.put("language", tag));
    return request("POST", "/chat", Optional.of(body));
  }

  @Override
  public CompletableFuture<JsonNode> hear(String person, String room, String text, boolean more) {
    ObjectNode body = JsonNodeFactory.instance.objectNode();
    body.put("person", person).put("room", room).put("text", text).put("more", more);
    return request("POST", "/chat/heard", Optional.of(body));
  }

  @Override
  public CompletableFuture<JsonNode> said(long after) {
    return get("/chat?after=" + after);
  }

  @Override
  public CompletableFuture<JsonNode> nextWords(String person, String room, String text) {
    return get(
        "/chat/words?person=%s&room=%s&text=%s"
            .formatted(encoded(person), encoded(room), encoded(text)));
  }

  @Override
  public CompletableFuture<JsonNode> order(AgentOrder order) {
    ObjectNode body = JsonNodeFactory.instance.objectNode();
    if (order instanceof AgentOrder.Add add) {
      body.put("description", add.description()).put("file", add.file());
      add.as().ifPresent(name -> body.put("as", name));
      add.container().ifPresent(name -> body.put("container", name));
      add.needs().forEach(body.putArray("needs")::add);
      return request("POST", "/agents", Optional.of(body));
    } else if (order instanceof AgentOrder.Move move) {
      body.put("to", move.to());
      return request("POST", agent(move.agent()) + "/moves", Optional.of(body));
    } else if (order instanceof AgentOrder.Reconfigure changed) {
      body.put("description", changed.description()).put("file", changed.file());
      return request("POST", agent(changed.agent()) + "/descriptions", Optional.of(body));
    }
    return request("DELETE", agent(((AgentOrder.Remove) order).agent()), Optional.empty());
  }

  private static String agent(String name) {
    return "/agents/" + encoded(name);
  }

  @Override
  public CompletableFuture<Void> stop(Optional<String> member) {
    String of = member.map(name -> "/members/" + encoded(name)).orElse("");
    return request("POST", of + "/safe-state", Optional.empty()).thenAccept(nothing -> {});
  }

  @Override
  public CompletableFuture<Void> revive() {
    return request("POST", "/coordinator/revival", Optional.empty()).thenAccept(nothing -> {});
  }

  private CompletableFuture<JsonNode> get(String path) {
    return request("GET", path, Optional.empty());
  }

  private CompletableFuture<JsonNode> request(String method, String path, Optional<JsonNode> body) {
    try {
      return CompletableFuture.completedFuture(
          answer(method, console.resolve(Api.ROOT + path), body));
    } catch (RefusalException e) {
      return CompletableFuture.failedFuture(e);
    } catch (IOException e) {
      throw new UnreachableConsoleException(console.toString(), e);
    }
  }

  private JsonNode answer(String method, URI at, Optional<JsonNode> sent) throws IOException {
    HttpURLConnection connection = (HttpURLConnection) at.toURL().openConnection();
    person.ifPresent(known -> present(known, connection));
    connection.setRequestMethod(method);
    connection.setConnectTimeout(CONNECT_MILLIS);
    connection.setReadTimeout(ANSWER_WITHIN_MILLIS);
    if (sent.isPresent()) {
      connection.setDoOutput(true);
      connection.setRequestProperty("Content-Type", "application/json");
      try (OutputStream out = connection.getOutputStream()) {
        out.write(sent.get().toString().getBytes(StandardCharsets.UTF_8));
      }
    }
    int status = connection.getResponseCode();
    if (status >= FIRST_BAD_STATUS) {
      throw refusal(connection, status);
    }
    try (InputStream body = connection.getInputStream()) {
      byte[] bytes = body.readAllBytes();
      return bytes.length == 0
          ? JsonNodeFactory.instance.nullNode()
          : new ObjectMapper().readTree(bytes);
    }
  }

  private static void present(Credentials person, HttpURLConnection connection) {
    if (connection instanceof HttpsURLConnection secured) {
      secured.setSSLSocketFactory(person.tls().getSocketFactory());
      String both = person.user() + ":" + person.password().orElse("");
      connection.setRequestProperty(
          "Authorization",
          "Basic " + Base64.getEncoder().encodeToString(both.getBytes(StandardCharsets.UTF_8)));
    }
  }

  private static RefusalException refusal(HttpURLConnection connection, int status)
      throws IOException {
    try (InputStream body = connection.getErrorStream()) {
      JsonNode problem =
          body == null
              ? JsonNodeFactory.instance.objectNode()
              : new ObjectMapper().readTree(body.readAllBytes());
      String sentence =
          problem.path("problem").asText("The console answers with the status " + status + ".");
      return problem.path("kind").asText().equals("bad-input")
          ? RefusalException.badInput(sentence)
          : RefusalException.outside(sentence);
    } catch (JsonProcessingException e) {
      return RefusalException.outside("What answers there is no console.");
    }
  }

  private static String encoded(String text) {
    return URLEncoder.encode(text, StandardCharsets.UTF_8).replace("+", "%20");
  }
}
