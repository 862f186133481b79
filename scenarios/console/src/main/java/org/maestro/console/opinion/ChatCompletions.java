package org.maestro.console.opinion;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.TimeUnit;
import org.maestro.dialogue.Paraphraser;
import org.maestro.dialogue.Sayable;

/**
 * A language model that is asked by {@code POST /chat/completions}, as many servers understand it.
 * Any thread may ask; nothing waits.
 */
public final class ChatCompletions implements Paraphraser {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int OK = 200;
  private static final int MOST_BYTES = 64 << 10;
  private static final int MOST_PROPOSALS = 3;
  private static final int LONGEST_PROPOSAL = 200;
  private static final int MOST_TOKENS = 80;
  private static final int MOST_PATTERNS = 150;
  private static final int MOST_NAMES = 150;

  private final URI address;
  private final Optional<String> model;
  private final Optional<String> key;
  private final Duration patience;
  private final HttpClient client;

  /**
   * @param base such as {@code http://127.0.0.1:8080/v1}
   * @param model its name, where the server has several
   * @param key a secret by which the server knows who asks
   * @param patience wall time; who answers later has not answered
   */
  public ChatCompletions(
      URI base, Optional<String> model, Optional<String> key, Duration patience) {
    this.address = URI.create(base.toString().replaceAll("/+$", "") + "/chat/completions");
    this.model = model;
    this.key = key;
    this.patience = patience;
    this.client = HttpClient.newBuilder().connectTimeout(patience).build();
  }

  @Override
  public CompletableFuture<List<String>> proposals(String said, Sayable known) {
    HttpRequest.Builder request =
        HttpRequest.newBuilder(address)
            .timeout(patience)
            .header("Content-Type", "application/json")
            .POST(HttpRequest.BodyPublishers.ofString(body(said, known).toString()));
    key.ifPresent(secret -> request.header("Authorization", "Bearer " + secret));
    CompletableFuture<HttpResponse<byte[]>> exchange =
        client.sendAsync(request.build(), answer -> new FirstBytes(MOST_BYTES));
    return exchange
        .thenApply(this::proposed)
        .orTimeout(patience.toMillis(), TimeUnit.MILLISECONDS)
        .whenComplete(
            (proposals, failure) -> {
              if (failure != null) {
                exchange.cancel(true);
              }
            });
  }

  private ObjectNode body(String said, Sayable known) {
    ObjectNode body = JSON.createObjectNode();
    model.ifPresent(name -> body.put("model", name));
    body.put("temperature", 0).put("max_tokens", MOST_TOKENS).put("stream", false);
    ArrayNode messages = body.putArray("messages");
    messages.addObject().put("role", "system").put("content", instruction(known));
    messages.addObject().put("role", "user").put("content", said);
    return body;
  }

  private static String instruction(Sayable known) {
    return instruction()
        .replace(
            "{patterns}",
            String.join("\n", known.patterns().stream().limit(MOST_PATTERNS).toList()))
        .replace("{names}", String.join(", ", known.names().stream().limit(MOST_NAMES).toList()));
  }

  private static String instruction() {
    try (InputStream stream = ChatCompletions.class.getResourceAsStream("instruction.txt")) {
      return new String(
          Objects.requireNonNull(stream, "instruction.txt is not there").readAllBytes(),
          StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Whatever the answer is, no more of it is read than a few sentences take. */
  private List<String> proposed(HttpResponse<byte[]> response) {
    if (response.statusCode() != OK) {
      throw failed("it answers with status " + response.statusCode());
    }
    try {
      JsonNode text =
          JSON.readTree(new String(response.body(), StandardCharsets.UTF_8))
              .path("choices")
              .path(0)
              .path("message")
              .path("content");
      return text.asText("")
          .lines()
          .map(line -> line.replaceAll("^[\\s\\-*\"'`\\d.)]+|[\\s\"'`]+$", ""))
          .filter(line -> !line.isBlank() && line.length() <= LONGEST_PROPOSAL)
          .distinct()
          .limit(MOST_PROPOSALS)
          .toList();
    } catch (JsonProcessingException e) {
      throw failed("its answer is no JSON");
    }
  }

  private CompletionException failed(String why) {
    return new CompletionException(
        new IOException("The second opinion at %s is none: %s.".formatted(address, why)));
  }
}
