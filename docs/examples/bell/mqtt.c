#define _POSIX_C_SOURCE 200809L
#include "mqtt.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

enum { CONNECT = 0x10, CONNACK = 0x20, PUBLISH = 0x30, PUBACK = 0x40, SUBSCRIBE = 0x82, PINGREQ = 0xc0 };
enum { DISCONNECT = 0xe0, RETAIN = 1, AT_LEAST_ONCE = 2, ANY_QUALITY = 6, IS_ANOTHER = 0x8e };

static unsigned char in[MOST_IN], out[MOST_OUT];
static size_t in_length, out_length;
static unsigned number; /* of what is sent, and has to be acknowledged */
static unsigned char unanswered[2];
static bool is_unanswered;
static int bus = -1;
static int64_t sent_ms, heard_ms;

int64_t now_ms(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static void hang_up(void) {
  if (bus >= 0) close(bus);
  bus = -1;
  is_unanswered = false;
}

/* --- What is sent */

static void begin(void) { out_length = 3; } /* of which the first byte and the length, one byte or two */

static void put(const void *bytes, size_t length) {
  if (out_length + length <= sizeof out) memcpy(out + out_length, bytes, length);
  out_length += length;
}

static void put_byte(unsigned byte) { put(&(unsigned char){(unsigned char)byte}, 1); }

static void put_number(unsigned two_bytes) {
  put_byte(two_bytes >> 8);
  put_byte(two_bytes & 255);
}

static void put_text(const char *text) {
  put_number((unsigned)strlen(text));
  put(text, strlen(text));
}

static void end(unsigned kind) {
  size_t length = out_length - 3, first = length > 127 ? 0 : 1;
  if (bus < 0 || out_length >= sizeof out) return;
  out[first] = (unsigned char)kind;
  out[first + 1] = (unsigned char)(length > 127 ? length | 128 : length);
  if (length > 127) out[2] = (unsigned char)(length >> 7);
  while (first < out_length) {
    ssize_t taken = send(bus, out + first, out_length - first, MSG_NOSIGNAL);
    if (taken <= 0) {
      hang_up();
      return;
    }
    first += (size_t)taken;
  }
  sent_ms = now_ms();
}

void mqtt_begin(const char *topic, ...) {
  char text[MOST_TOPIC];
  va_list values;
  va_start(values, topic);
  vsnprintf(text, sizeof text, topic, values);
  va_end(values);
  begin();
  put_text(text);
  put_number(number = number % 65535 + 1);
  put_byte(0); /* no properties */
}

void mqtt_say(const char *part, ...) {
  size_t left = out_length < sizeof out ? sizeof out - out_length : 0;
  va_list values;
  va_start(values, part);
  out_length += (size_t)vsnprintf(left > 0 ? (char *)out + out_length : NULL, left, part, values);
  va_end(values);
}

void mqtt_send(bool retained) { end(PUBLISH | AT_LEAST_ONCE | (retained ? RETAIN : 0)); }

/* --- What is received */

static bool receive(unsigned char *into, size_t length) {
  while (bus >= 0 && length > 0) {
    ssize_t got = recv(bus, into, length, 0);
    if (got <= 0) {
      hang_up();
    } else {
      into += got;
      length -= (size_t)got;
    }
  }
  return bus >= 0;
}

/* The packet's first byte; 0 when the bus is gone. What does not fit of it is dropped. */
static unsigned receive_packet(void) {
  unsigned char kind, byte = 0;
  size_t length = 0;
  if (!receive(&kind, 1)) return 0;
  for (int shift = 0; shift < 28; shift += 7) {
    if (!receive(&byte, 1)) return 0;
    length |= (size_t)(byte & 127) << shift;
    if (byte < 128) break;
  }
  in_length = length < sizeof in ? length : sizeof in;
  if (!receive(in, in_length)) return 0;
  for (length -= in_length; length > 0; length--)
    if (!receive(&byte, 1)) return 0;
  heard_ms = now_ms();
  return kind;
}

static Event arrived(unsigned kind, Message *message) {
  size_t topic_length = in_length < 2 ? 0 : (size_t)in[0] << 8 | in[1];
  size_t properties = 2 + topic_length + ((kind & ANY_QUALITY) != 0 ? 2 : 0);
  if (properties >= in_length || in[properties] > 127 || properties + 1 + in[properties] > in_length) {
    hang_up(); /* nobody on this bus has more of them */
    return GONE;
  }
  const char *packet = (const char *)in;
  message->topic = (Text){packet + 2, packet + 2 + topic_length};
  message->payload = (Text){packet + properties + 1 + in[properties], packet + in_length};
  message->is_retained = (kind & RETAIN) != 0;
  is_unanswered = (kind & ANY_QUALITY) != 0;
  memcpy(unanswered, in + properties - 2, sizeof unanswered);
  return MESSAGE;
}

Event mqtt_wait(int64_t until_ms, Message *message) {
  if (is_unanswered) {
    begin();
    put(unanswered, sizeof unanswered);
    end(PUBACK);
    is_unanswered = false;
  }
  if (now_ms() - sent_ms >= KEEP_ALIVE_SECONDS * 500) {
    begin();
    end(PINGREQ);
  }
  if (now_ms() - heard_ms > KEEP_ALIVE_SECONDS * 1500) hang_up();
  int64_t ping_ms = sent_ms + KEEP_ALIVE_SECONDS * 500, wait_ms = (ping_ms < until_ms ? ping_ms : until_ms) - now_ms();
  struct pollfd readable = {.fd = bus, .events = POLLIN};
  if (bus < 0) return GONE;
  if (poll(&readable, 1, wait_ms > 0 ? (int)wait_ms : 0) <= 0) return NOTHING;
  unsigned kind = receive_packet();
  if (kind == 0) return GONE;
  if (kind == DISCONNECT && in_length > 0 && in[0] == IS_ANOTHER) return TAKEN_OVER;
  return (kind & 0xf0) == PUBLISH ? arrived(kind, message) : NOTHING;
}

/* --- The beginning */

static void dial(const char *host, const char *port) {
  struct addrinfo wanted = {.ai_socktype = SOCK_STREAM}, *found = NULL;
  struct timeval patience = {.tv_sec = PATIENCE_SECONDS};
  int yes = 1;
  if (getaddrinfo(host, port, &wanted, &found) != 0) return;
  bus = socket(found->ai_family, SOCK_STREAM, 0);
  if (bus >= 0) {
    setsockopt(bus, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(bus, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    setsockopt(bus, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    if (connect(bus, found->ai_addr, found->ai_addrlen) != 0) hang_up();
  }
  freeaddrinfo(found);
}

bool mqtt_connect(const char *host, const char *port, const char *client, const char *will_topic, const char *will) {
  dial(host, port);
  begin();
  put_text("MQTT");
  put_byte(5);
  put_byte(0x2e); /* a clean start; a will, by quality of service 1, retained */
  put_number(KEEP_ALIVE_SECONDS);
  put_byte(8); /* bytes of properties */
  put_byte(0x27);
  put_number(0);
  put_number(MOST_IN);
  put_byte(0x21);
  put_number(MOST_UNANSWERED);
  put_text(client);
  put_byte(0); /* the will has no properties */
  put_text(will_topic);
  put_text(will);
  end(CONNECT);
  bool is_in = receive_packet() == CONNACK && in_length > 1 && in[1] == 0;
  if (!is_in) hang_up();
  return is_in;
}

void mqtt_hear(const char *filter, unsigned char how) {
  begin();
  put_number(number = number % 65535 + 1);
  put_byte(0); /* no properties */
  put_text(filter);
  put_byte(how);
  end(SUBSCRIBE);
}
