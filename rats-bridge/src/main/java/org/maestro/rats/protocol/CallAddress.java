package org.maestro.rats.protocol;

/** The id and the member of a malformed call: enough to refuse it. */
public record CallAddress(String id, String member) {}
