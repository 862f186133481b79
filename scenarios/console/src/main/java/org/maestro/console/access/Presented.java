package org.maestro.console.access;

import java.util.Optional;

/**
 * What a request brings that tells who it is from.
 *
 * @param address where it comes from
 * @param authorization the header of that name
 * @param session the token of a session, which a browser sends with each request
 * @param csrf the session's other token, which only a page of ours can have sent
 * @param changes whether it may change something
 * @param urgent whether it is answered however much else is asked
 */
public record Presented(
    String address,
    Optional<String> authorization,
    Optional<String> session,
    Optional<String> csrf,
    boolean changes,
    boolean urgent) {

  @Override
  public String toString() {
    return "a request from " + address;
  }
}
